// What colour segments have where a ray meets them.
// Include "field/shaders/scene.glsl" first; declare `corners`.

#include "render/shaders/segment_colours.glsl"

// Adds the mean of what the corners of p's cell say, weighted as trilinear interpolation does, so that
// borders between segments do not show voxels; of segments of one kind only. Not if not `wanted`.
void addColoursAround(vec3 p, bool translucent, bool wanted, inout vec4 sum, inout float weights) {
    LabelCell cell = LabelCell(ivec3(0), vec3(0.0), false);
    bool isLookedUp = wanted; // or bricks would be asked for that nobody needs
    while (isLookedUp) {
        cell = labelCellAt(p);
        isLookedUp = false;
    }
    int count = wanted ? corners : 0;
    for (int corner = 0; corner < count; ++corner) {
        ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        uint segment = labelAt(cell, offset);
        vec4 entry = entryOf(segment);
        bool isOfKind = segment != 0u && (translucent ? entry.a > 0.0 && entry.a < 1.0 : entry.a >= 1.0);
        vec3 w = mix(1.0 - cell.part, cell.part, vec3(offset));
        float weight = isOfKind ? w.x * w.y * w.z : 0.0;
        sum += weight * entry;
        weights += weight;
    }
}

// The label of the nearest voxel around p. Of finer levels, where that has none, of the nearest one that is
// in a segment; not if that is not `wanted`.
uint labelNear(vec3 p, bool wanted) {
    LabelCell cell = labelCellAt(p);
    uint label = labelAt(cell, ivec3(floor(cell.part + 0.5)));
#ifdef FINER_SEGMENTS
    int count = wanted && label == 0u ? corners : 0;
    float most = 0.0;
    for (int corner = 0; corner < count; ++corner) {
        ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        uint other = labelAt(cell, offset);
        vec3 w = mix(1.0 - cell.part, cell.part, vec3(offset));
        float weight = other == 0u ? 0.0 : w.x * w.y * w.z;
        label = weight > most ? other : label;
        most = max(most, weight);
    }
#endif
    return label;
}

// What tints the data at p, where rays go through segments instead of meeting their surfaces: linear colour,
// and how much of it.
vec4 tintAt(vec3 p) {
    vec2 memberships = membershipsAt(p);
    float amount = smoothstep(0.25, 0.75, max(memberships.x, memberships.y));
#ifdef PULLED
    uint segment = uint(pulled.x);
#else
    uint segment = labelNear(p, amount > 0.0);
#endif
    vec4 entry = entryOf(segment);
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
    addColoursAround(p + mat3(voxelFromWorld) * inwards * spacing.w * segmentStep(), translucent, isOutside,
                     sum, weights);
    return weights < some ? entryOf(0u) : sum / weights;
#endif
}
