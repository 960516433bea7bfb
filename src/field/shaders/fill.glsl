// Material that a person has added (field/fill/fill.h). Texture 17, uniform block 6 (field::FillTexture).
// Included by scene.glsl, where there is any. FILLED: 1, or 2 where some materials are not seen.

#include "field/shaders/bindings.glsl"
layout(std140, binding = kFillBlock) uniform FillBlock {
    ivec4 fillBricks;   // xyz bricks along each axis, w where they begin in fillWords
    uvec4 fillSeen;     // x bit n: whether material n is seen
    vec4 materials[32]; // by number: linear colour, w value
};
// For each brick 0, its number counted from 1, or with the highest bit set the material that all of it is of;
// then the bricks: for each cell (and, along z, one more) how much its four corners with the lesser z are
// filled, in two words, and after those their materials.
layout(binding = kFillTexture) uniform usamplerBuffer fillWords;

const int kFillShift = 4; // a brick is 1 << this voxels wide
const int kFillBrick = 1 << kFillShift;
const int kFillPlane = kFillBrick * kFillBrick; // cells
const int kFillCells = kFillPlane * (kFillBrick + 1);
const int kFillSlot = 3 * kFillCells; // words of a brick
const uint kWholeBrick = 0x80000000u;

// Where a place is in the fill.
struct FillCell {
    uint page;
    int begin; // of the brick, in words
    int cell;  // in the brick
    vec3 part; // of the cell
};

FillCell fillCellAt(vec3 p) {
    vec3 q = clamp(p, vec3(0.0), vec3(dims.xyz - 1));
    ivec3 first = ivec3(q);
    ivec3 brick = first >> kFillShift;
    ivec3 within = first & (kFillBrick - 1);
    FillCell cell;
    cell.page = texelFetch(fillWords, (brick.z * fillBricks.y + brick.y) * fillBricks.x + brick.x).r;
    cell.begin = fillBricks.w + (int(cell.page & ~kWholeBrick) - 1) * kFillSlot;
    cell.cell = (((within.z << kFillShift) + within.y) << kFillShift) + within.x;
    cell.part = q - vec3(first);
    return cell;
}

bool isInBrick(FillCell cell) { return cell.page != 0u && cell.page < kWholeBrick; }

vec4 filledCorners(int word) {
    return vec4(unpackUnorm2x16(texelFetch(fillWords, word).r),
                unpackUnorm2x16(texelFetch(fillWords, word + 1).r));
}

uvec4 materialCorners(int word) {
    return (uvec4(texelFetch(fillWords, word).r) >> uvec4(0u, 8u, 16u, 24u)) & 0xffu;
}

bool isSeen(uint material) { return ((fillSeen.x >> material) & 1u) != 0u; }
vec4 areSeen(uvec4 material) { return vec4((uvec4(fillSeen.x) >> material) & 1u); }

// What the corners of a cell add to how much a place in it is filled: those with the lesser z (front) and the
// others.
void sharesIn(FillCell cell, out vec4 front, out vec4 back) {
    vec2 f = cell.part.xy;
    vec4 across = vec4(1.0 - f.x, f.x, 1.0 - f.x, f.x) * vec4(vec2(1.0 - f.y), vec2(f.y));
    front = across * (1.0 - cell.part.z);
    back = across * cell.part.z;
    int word = cell.begin + 2 * cell.cell;
    front *= filledCorners(word);
    back *= filledCorners(word + 2 * kFillPlane);
}

// How much p is filled, by anything (x) and by what is seen (y); surfaces are at 0.5.
vec2 filledAt(vec3 p) {
    FillCell cell = fillCellAt(p);
    bool isWhole = cell.page >= kWholeBrick;
    vec2 filled = vec2(isWhole, isWhole && isSeen(cell.page & 31u));
    bool isLookedUp = isInBrick(cell); // a loop: software renderers leave it where no ray of a group needs it
    while (isLookedUp) {
        vec4 front;
        vec4 back;
        sharesIn(cell, front, back);
        filled.x = dot(front + back, vec4(1.0));
#if FILLED == 1
        filled.y = filled.x;
#else
        int materialWord = cell.begin + 2 * kFillCells + cell.cell;
        filled.y = dot(front, areSeen(materialCorners(materialWord))) +
                   dot(back, areSeen(materialCorners(materialWord + kFillPlane)));
#endif
        isLookedUp = false;
    }
    return filled;
}

float filledBySeen(vec3 p) { return filledAt(p).y; }
float filledByAny(vec3 p) { return filledAt(p).x; }

// The material at a place that is filled: of the corners of its cell the one that counts most. Not if that is
// not `wanted`.
uint materialAt(vec3 p, bool wanted) {
    FillCell cell = fillCellAt(p);
    uint material = cell.page & 31u;
    bool isLookedUp = wanted && isInBrick(cell);
    while (isLookedUp) {
        vec4 front;
        vec4 back;
        sharesIn(cell, front, back);
        int materialWord = cell.begin + 2 * kFillCells + cell.cell;
        uvec4 inFront = materialCorners(materialWord);
        uvec4 behind = materialCorners(materialWord + kFillPlane);
        float most = 0.0;
        for (int i = 0; i < 4; ++i) {
            material = front[i] > most ? inFront[i] : material;
            most = max(most, front[i]);
            material = back[i] > most ? behind[i] : material;
            most = max(most, back[i]);
        }
        isLookedUp = false;
    }
    return material & 31u;
}

// A value of the scan, or that of the material that is seen at p instead.
float orMaterial(float value, vec3 p) {
    bool isFilled = filledAt(p).y >= 0.5;
    uint material = materialAt(p, isFilled);
    return isFilled ? materials[material].w : value;
}
