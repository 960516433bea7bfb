// Colour and opacity of values: the transfer function's tables (render::Classification).
// TF_KIND: 0 over intensity, 1 over gradient magnitude, 2 over both. Gradient magnitudes that the kind does
// not use may be passed as 0 and need not be computed; mayBeVisible() is the same for all kinds. Values in
// the volume's unit, gradient magnitudes in that unit per mm ("render/shaders/gradients.glsl"). Bindings:
// uniform block 2; textures 5 the function, 7 counts of what is visible, 10 the function over spans (kind 0).

#include "render/shaders/bindings.glsl"
layout(std140, binding = kClassificationBlock) uniform ClassificationBlock {
    vec4 valueAxis;    // x scale, y offset to a table coordinate 0..1; z lowest value that counts, w columns
    vec4 gradientAxis; // x scale, y offset to a table coordinate 0..1; zw the same for values, to columns
    vec4 lightingOfFunction; // x amount: 0 glows by itself, 1 lit as a surface; y gloss; z opacity per
    // step that a pen meets; w gradient magnitude that is kept as 1
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

const float kHair = 1e-2; // columns and rows: what rounding may shift a place by

// The columns of the tables that values from lo to hi touch: from x up to, and not with, y.
ivec2 columnsOf(float lo, float hi) {
    vec2 place = (vec2(max(lo, valueAxis.z), hi) * valueAxis.x + valueAxis.y) * valueAxis.w - 0.5;
    place = clamp(place + vec2(-kHair, kHair), 0.0, valueAxis.w - 1.0);
    return ivec2(int(floor(place.x)), int(ceil(place.y)) + 1);
}

bool isAnyVisible(ivec2 columns, int rows) {
    uint before = texelFetch(visibleBefore, ivec2(columns.x, rows), 0).r;
    uint upTo = texelFetch(visibleBefore, ivec2(columns.y, rows), 0).r;
    return upTo > before;
}

// Whether any value from lo to hi may have opacity with some gradient magnitude, or with one up to
// `steepest`. Never false for one that has.
bool mayBeVisible(float lo, float hi) {
    int rows = textureSize(visibleBefore, 0).y - 1;
    return hi >= valueAxis.z && lo <= hi && isAnyVisible(columnsOf(lo, hi), rows);
}

bool mayBeVisible(float lo, float hi, float steepest) {
    float rows = float(textureSize(visibleBefore, 0).y - 1);
    float row = (steepest * gradientAxis.x + gradientAxis.y) * rows - 0.5 + kHair;
    int upTo = int(ceil(clamp(row, 0.0, rows - 1.0))) + 1;
    return hi >= valueAxis.z && lo <= hi && isAnyVisible(columnsOf(lo, hi), upTo);
}
