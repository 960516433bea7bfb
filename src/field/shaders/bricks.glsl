// Values of a level that is finer than the scene's grid, from bricks of it (field/bricks/detail.h). A brick
// lies in a slot of the pool with the first voxels of the bricks behind it, so that what lies between its
// voxels and theirs is found in it too. Where it is not there the scene's own value stands in, and
// `isBrickMissing` tells that the invocation has met such a place. Included by scene.glsl.

layout(std140, binding = kBricksBlock) uniform BricksBlock {
    vec4 levelScale;   // xyz place in the level = place in the scene * this, w steps of the scene in one of
                       // the level's
    vec4 levelOrigin;  // xyz + this, w 1 / side of a brick
    ivec4 levelDims;   // xyz voxels of the level, w side of a brick
    ivec4 brickCounts; // w all of them
    vec4 poolScale;    // xyz 1 / texels of the pool, w texels of a slot
    vec4 brickValue;   // x scale, y offset
    ivec4 brickCells;  // xy slots of the pool, z where ranges of cells begin, w cells of a brick along each
                       // axis, 0 if theirs are not there
};

// Of each brick of the level: 0 it is not there, 1 it never will be, else where its slot lies, ten bits an
// axis, and the highest one. Behind them, of each brick too, the range of its values (rangeOf()); behind
// these, of each slot of the pool, the ranges of the cells of the brick that lies in it.
layout(binding = kBrickPagesTexture) uniform usamplerBuffer brickPages;
layout(binding = kBrickPoolTexture) uniform sampler3D brickPool;
layout(std430, binding = kBrickUsesStorage) writeonly buffer BrickUses { uint brickUses[]; };

const int kBrickCell = 8; // voxels of a cell along each axis, as in field/bricks/brick_ranges.h

int lastBrick = -1;
bool isBrickMissing = false;

vec3 levelFromVoxel(vec3 p) { return p * levelScale.xyz + levelOrigin.xyz; }

int brickNumber(ivec3 brick) { return (brick.z * brickCounts.y + brick.y) * brickCounts.x + brick.x; }
uvec3 slotOf(uint page) { return uvec3(page, page >> 10, page >> 20) & 0x3ffu; }

// The smallest and the largest value that samples can have.
vec2 rangeOf(uint word) { return uintBitsToFloat(uvec2(word << 16, word & 0xffff0000u)); }

// A box of the level's voxel space, and what samples in it can have.
struct Held {
    vec2 range;
    vec3 lower;
    vec3 upper;
};

// What the brick holds that has a place in it. Anything, if it was never read.
Held heldByBrick(ivec3 brick) {
    vec3 lower = vec3(brick * levelDims.w);
    uint word = texelFetch(brickPages, brickCounts.w + brickNumber(brick)).r;
    return Held(rangeOf(word), lower, lower + float(levelDims.w));
}

// What the brick's cell holds that has a place in it. Anything, if the brick is not there.
Held heldByCell(ivec3 brick, vec3 q) {
    uint page = texelFetch(brickPages, brickNumber(brick)).r;
    ivec3 slot = ivec3(slotOf(page));
    ivec3 first = brick * levelDims.w;
    ivec3 cell = clamp((ivec3(q) - first) / kBrickCell, ivec3(0), ivec3(brickCells.w - 1));
    int place = ((slot.z * brickCells.y + slot.y) * brickCells.x + slot.x) * brickCells.w;
    place = ((place + cell.z) * brickCells.w + cell.y) * brickCells.w + cell.x;
    vec2 range = rangeOf(texelFetch(brickPages, brickCells.z + place).r);
    vec3 lower = vec3(first + cell * kBrickCell);
    vec3 upper = min(lower + float(kBrickCell), vec3(first + levelDims.w)); // the last may be cut short
    return Held(page >= 2u ? range : vec2(-1e38, 1e38), lower, upper);
}

// Where in the pool a place in the level's voxel space is found: the first texel of its brick's slot, and
// what lies between that and the place, in texels; false: its brick is not there. Loops instead of branches:
// a software renderer leaves them where nothing is to be done, and does both sides of a branch.
bool findInPool(vec3 q, out vec3 slot, out vec3 inBrick) {
    vec3 inside = clamp(q, vec3(0.0), vec3(levelDims.xyz - 1));
    ivec3 brick = ivec3(inside * levelOrigin.w);
    int number = brickNumber(brick);
    uint page = texelFetch(brickPages, number).r;
    bool isNew = number != lastBrick;
    while (isNew) {
        brickUses[number] = 1u;
        lastBrick = number;
        isBrickMissing = isBrickMissing || page == 0u;
        isNew = false;
    }
    inBrick = max(inside - vec3(brick * levelDims.w), 0.0);
    slot = vec3(slotOf(page)) * poolScale.w;
    return page >= 2u;
}

// What lies there. FETCHED: the same to the last bit, whichever slot the brick lies in.
float fetchedInPool(sampler3D pool, vec3 slot, vec3 inBrick, Meaning meaning) {
    ivec3 cell = ivec3(inBrick);
    ivec3 first = ivec3(slot) + cell;
    return fetchedBetween(pool, first, first + 1, inBrick - vec3(cell), meaning);
}
#ifdef FETCHED
float inPool(sampler3D pool, vec3 slot, vec3 inBrick) {
    return fetchedInPool(pool, slot, inBrick, kThemselves);
}
#else
float inPool(sampler3D pool, vec3 slot, vec3 inBrick) {
    return textureLod(pool, (slot + inBrick + 0.5) * poolScale.xyz, 0.0).r;
}
#endif

// A value in the volume's unit; where the brick is away the scene's own stands in.
float valueOrScenes(vec3 q, float value, bool isAway) {
    while (isAway) {
        vec3 p = (q - levelOrigin.xyz) / levelScale.xyz;
        value = textureLod(dataTexture, textureFromVoxel(p), 0.0).r * dataScale().x + dataScale().y;
        isAway = false;
    }
    return value;
}

// The value at a place in the level's voxel space.
float levelValueAt(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isAway = !findInPool(q, slot, inBrick);
    return valueOrScenes(q, inPool(brickPool, slot, inBrick) * brickValue.x + brickValue.y, isAway);
}
float fetchedLevelValueAt(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isAway = !findInPool(q, slot, inBrick);
    return valueOrScenes(q, fetchedInPool(brickPool, slot, inBrick, meaningOfData(brickValue.xy)), isAway);
}

#ifdef FINER_CUTS
// What was cut away at the finest level, as it lies over the bricks of this one.
layout(binding = kBrickCutsTexture) uniform sampler3D brickCuts;

float cutOrScenes(vec3 q, float cut, bool isAway) {
    while (isAway) {
        vec3 p = (q - levelOrigin.xyz) / levelScale.xyz;
        cut = textureLod(sculptureTexture, textureFromVoxel(p), 0.0).r;
        isAway = false;
    }
    return cut;
}

float levelSculptureAt(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isAway = !findInPool(q, slot, inBrick);
    return cutOrScenes(q, inPool(brickCuts, slot, inBrick), isAway);
}
float fetchedLevelSculptureAt(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isAway = !findInPool(q, slot, inBrick);
    return cutOrScenes(q, fetchedInPool(brickCuts, slot, inBrick, kThemselves), isAway);
}
#endif

#ifdef FINER_SEGMENTS
// Segments of the finest level, likewise: how much belongs to opaque ones, where FINER_SEGMENTS is 2 also how
// much to translucent ones, and behind these the label of the segment that has a voxel, 0 for none.
layout(binding = kBrickSegmentsTexture) uniform sampler3D brickSegments;

vec2 membershipsOf(vec4 texel) { return FINER_SEGMENTS == 2 ? texel.rg : vec2(texel.r, 0.0); }
uint labelOf(vec4 texel) { return uint(texel[FINER_SEGMENTS] * 255.0 + 0.5); }

#ifdef FETCHED
vec2 pairInPool(sampler3D pool, vec3 slot, vec3 inBrick) {
    ivec3 cell = ivec3(inBrick);
    vec3 f = inBrick - vec3(cell);
    ivec3 first = ivec3(slot) + cell;
    vec2 sum = vec2(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 offset = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        vec3 w = mix(1.0 - f, f, vec3(offset));
        sum += w.x * w.y * w.z * membershipsOf(texelFetch(pool, first + offset, 0));
    }
    return sum;
}
#else
vec2 pairInPool(sampler3D pool, vec3 slot, vec3 inBrick) {
    return membershipsOf(textureLod(pool, (slot + inBrick + 0.5) * poolScale.xyz, 0.0));
}
#endif

vec2 levelMembershipsAt(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isAway = !findInPool(q, slot, inBrick);
    vec2 memberships = pairInPool(brickSegments, slot, inBrick);
    while (isAway) {
        vec3 p = (q - levelOrigin.xyz) / levelScale.xyz;
        memberships = textureLod(segmentationTexture, textureFromVoxel(p), 0.0).rg;
        isAway = false;
    }
    return memberships;
}

// The cell around a place in the level's voxel space, for the labels at its corners. Where its brick is not
// there, that of the scene's voxels.
LabelCell levelLabelCell(vec3 q) {
    vec3 slot;
    vec3 inBrick;
    bool isInPool = findInPool(q, slot, inBrick);
    vec3 p = (q - levelOrigin.xyz) / levelScale.xyz;
    ivec3 first = isInPool ? ivec3(slot) + ivec3(inBrick) : ivec3(floor(p));
    return LabelCell(first, isInPool ? inBrick - floor(inBrick) : p - floor(p), isInPool);
}

uint levelLabelAt(LabelCell cell, ivec3 offset) {
    uint label = labelOf(texelFetch(brickSegments, cell.isInPool ? cell.first + offset : ivec3(0), 0));
    bool isOfScene = !cell.isInPool;
    while (isOfScene) {
        label = segmentOf(cell.first + offset);
        isOfScene = false;
    }
    return label;
}
#endif
