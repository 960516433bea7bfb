// What colour segments have where a ray meets them.
// Bindings: texture 14 (render::SegmentColours). Include "field/shaders/scene.glsl" first; declare `corners`.

#include "render/shaders/bindings.glsl"
layout(binding = kSegmentColoursTexture) uniform sampler2D
    segmentColours; // one row of 256, by label: linear, a opacity

vec4 entryOf(uint segment) { return texelFetch(segmentColours, ivec2(int(segment), 0), 0); }

// Adds the mean of what the corners of p's cell say, weighted as trilinear interpolation does, so that
// borders between segments do not show voxels; of segments of one kind only. Not if not `wanted`.
void addColoursAround(vec3 p, bool translucent, bool wanted, inout vec4 sum, inout float weights) {
    vec3 first = floor(p);
    vec3 f = p - first;
    int count = wanted ? corners : 0;
    for (int corner = 0; corner < count; ++corner) {
        ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        uint segment = segmentOf(ivec3(first) + offset);
        vec4 entry = entryOf(segment);
        bool isOfKind = segment != 0u && (translucent ? entry.a > 0.0 && entry.a < 1.0 : entry.a >= 1.0);
        vec3 w = mix(1.0 - f, f, vec3(offset));
        float weight = isOfKind ? w.x * w.y * w.z : 0.0;
        sum += weight * entry;
        weights += weight;
    }
}

// What tints the data at p, where rays go through segments instead of meeting their surfaces: linear colour,
// and how much of it.
vec4 tintAt(vec3 p) {
    vec2 memberships = membershipsAt(p);
#ifdef PULLED
    uint segment = uint(pulled.x);
#else
    uint segment = segmentOf(ivec3(floor(p + 0.5)));
#endif
    vec4 entry = entryOf(segment);
    float amount = smoothstep(0.25, 0.75, max(memberships.x, memberships.y));
    return vec4(entry.rgb, segment != 0u ? amount * entry.a : 0.0);
}

// Linear colour and opacity of the opaque or the translucent segments at p, which lies in one or, as surfaces
// are smooth, a little outside; then it is one voxel further `inwards` (world, unit). Anything if not
// `wanted`.
vec4 segmentColourAt(vec3 p, vec3 inwards, bool translucent, bool wanted) {
#ifdef PULLED
    return entryOf(uint(pulled.x));
#else
    const float some = 1e-3; // of the weights
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    addColoursAround(p, translucent, wanted, sum, weights);
    bool isOutside = wanted && weights < some;
    addColoursAround(p + mat3(voxelFromWorld) * inwards * spacing.w, translucent, isOutside, sum, weights);
    return weights < some ? entryOf(0u) : sum / weights;
#endif
}
