// Colour and opacity of values: the transfer function's tables (render::Classification).
// TF_KIND: 0 over intensity, 1 over gradient magnitude, 2 over both. Gradient magnitudes that the kind does
// not use may be passed as 0 and need not be computed; mayBeVisible() is the same for all kinds. Values in
// the volume's unit, gradient magnitudes in that unit per mm (length of dataGradient()). Bindings: uniform
// block 2; textures 5 the function, 7 counts of visible values, 10 the function over spans (kind 0).

#include "render/shaders/bindings.glsl"
layout(std140, binding = kClassificationBlock) uniform ClassificationBlock {
    vec4 valueAxis;    // x scale, y offset to a table coordinate 0..1; z lowest value that counts, w columns
    vec4 gradientAxis; // x scale, y offset to a table coordinate 0..1; zw the same for values, to columns
    vec4 lightingOfFunction; // x amount: 0 glows by itself, 1 lit as a surface; y gloss; z opacity per
    // step that a pen meets
};

layout(binding = kFunctionTableTexture) uniform sampler2D functionTable;
layout(binding = kVisibleBeforeTexture) uniform usampler2D visibleBefore;

// Linear colour, opacity per step; not premultiplied.
vec4 classify(float value, float gradientMagnitude) {
#if TF_KIND == 0
    vec2 place = vec2(value * valueAxis.x + valueAxis.y, 0.5);
#elif TF_KIND == 1
    vec2 place = vec2(gradientMagnitude * gradientAxis.x + gradientAxis.y, 0.5);
#else
    vec2 place = vec2(value * valueAxis.x + valueAxis.y, gradientMagnitude * gradientAxis.x + gradientAxis.y);
#endif
    vec4 c = textureLod(functionTable, clamp(place, 0.0, 1.0), 0.0);
    c.a = value >= valueAxis.z ? c.a : 0.0;
    return c;
}

#if TF_KIND == 0
layout(binding = kFunctionSpansTexture) uniform samplerBuffer functionSpans;

// Where a value lies in the tables, in columns; far below what counts as nothing.
float columnOf(float value) {
    float column = value * gradientAxis.z + gradientAxis.w;
    return value >= valueAxis.z ? column : -1e7;
}

// Where the value goes evenly from one place in the tables to another: linear colour, opacity over half a
// step. The span looked at (ClassificationTables::spans) is as wide as theirs or a little narrower: nothing
// from outside shows.
vec4 classifySpan(float one, float other) {
    const int margin = 8;
    const float widest = 4096.0;
    // The exponent and two bits of the fraction: four rows an octave.
    int row = (floatBitsToInt(clamp(abs(one - other), 1.0, widest)) >> 21) - (127 << 2);
    float middle = 0.5 * (one + other);
    int column = int(floor(middle));
    int texels = int(valueAxis.w) + 2 * margin;
    int texel = clamp((column >> max((row >> 2) - 3, 0)) + margin, 0, texels - 1);
    vec4 c = texelFetch(functionSpans, row * texels + texel);
    c.a = middle > -1e6 ? c.a : 0.0;
    return c;
}
#endif

// Whether any value from lo to hi may have opacity (with some gradient magnitude). Never false for one that
// has.
bool mayBeVisible(float lo, float hi) {
    const float hair = 1e-2; // columns: what rounding may shift a place by
    vec2 place = (vec2(max(lo, valueAxis.z), hi) * valueAxis.x + valueAxis.y) * valueAxis.w - 0.5;
    place = clamp(place + vec2(-hair, hair), 0.0, valueAxis.w - 1.0);
    uint before = texelFetch(visibleBefore, ivec2(int(floor(place.x)), 0), 0).r;
    uint upTo = texelFetch(visibleBefore, ivec2(int(ceil(place.y)) + 1, 0), 0).r;
    return hi >= valueAxis.z && lo <= hi && upTo > before;
}
