// Values of a level that is finer than the scene's grid, from bricks of it (field/bricks/detail.h). A brick
// lies in a slot of the pool with the first voxels of the bricks behind it, so that what lies between its
// voxels and theirs is found in it too. Where it is not there the scene's own value stands in, and
// `isBrickMissing` tells that the invocation has met such a place. Included by scene.glsl.

layout(std140, binding = kBricksBlock) uniform BricksBlock {
    vec4 levelScale;  // xyz place in the level = place in the scene * this, w steps of the scene in one of
                      // the level's
    vec4 levelOrigin; // xyz + this, w 1 / side of a brick
    ivec4 levelDims;  // xyz voxels of the level, w side of a brick
    ivec4 brickCounts;
    vec4 poolScale;  // xyz 1 / texels of the pool, w texels of a slot
    vec4 brickValue; // x scale, y offset
};

// Of each brick of the level: 0 it is not there, 1 it never will be, else where its slot lies, ten bits an
// axis, and the highest one.
layout(binding = kBrickPagesTexture) uniform usamplerBuffer brickPages;
layout(binding = kBrickPoolTexture) uniform sampler3D brickPool;
layout(std430, binding = kBrickUsesStorage) writeonly buffer BrickUses { uint brickUses[]; };

int lastBrick = -1;
bool isBrickMissing = false;

vec3 levelFromVoxel(vec3 p) { return p * levelScale.xyz + levelOrigin.xyz; }

// The value at a place in the level's voxel space. Loops instead of branches: a software renderer leaves them
// where nothing is to be done, and does both sides of a branch.
float levelValueAt(vec3 q) {
    vec3 inside = clamp(q, vec3(0.0), vec3(levelDims.xyz - 1));
    ivec3 brick = ivec3(inside * levelOrigin.w);
    int place = (brick.z * brickCounts.y + brick.y) * brickCounts.x + brick.x;
    uint page = texelFetch(brickPages, place).r;
    bool isNew = place != lastBrick;
    while (isNew) {
        brickUses[place] = 1u;
        lastBrick = place;
        isBrickMissing = isBrickMissing || page == 0u;
        isNew = false;
    }
    vec3 inBrick = max(inside - vec3(brick * levelDims.w), 0.0);
    vec3 slot = vec3(uvec3(page, page >> 10, page >> 20) & 0x3ffu);
    float value =
        textureLod(brickPool, (slot * poolScale.w + inBrick + 0.5) * poolScale.xyz, 0.0).r * brickValue.x +
        brickValue.y;
    bool isAway = page < 2u;
    while (isAway) {
        vec3 p = (q - levelOrigin.xyz) / levelScale.xyz;
        value = textureLod(dataTexture, textureFromVoxel(p), 0.0).r * dataScale().x + dataScale().y;
        isAway = false;
    }
    return value;
}
