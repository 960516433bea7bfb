// The colours that a person has laid on the material (field/marks/marks.h). Storage block 7
// (field::MarkBuffer). Include "field/shaders/scene.glsl" and what has linearFromDisplay() first.

#include "field/shaders/bindings.glsl"
layout(std430, binding = kMarksOfMaterialStorage) readonly buffer MarksOfMaterial {
    ivec4 markBricks;  // xyz bricks along each axis, w where they begin in markWords
    vec4 markPerVoxel; // xyz texels along each axis of a voxel
    uint markWords[];  // of each brick 0, or its number counted from 1; then the bricks
};

const int kMarkBrick = 16;
const int kMarkSide = kMarkBrick + 1; // of what a brick has, with the first texels of those behind it
const int kMarkColours = kMarkSide * kMarkSide * kMarkSide;
const int kMarkSlot = kMarkColours + (kMarkColours + 3) / 4; // words: colours, then coverage in bytes
const float kMarkRamp = 3.0; // texels, about a mark's edge, over which coverage grows from 0 to 1

// Linear colour and opacity in a brick, between the texel `inside` it and those behind that.
vec4 markInBrick(int number, ivec3 inside, vec3 part, float pixelSteps) {
    int begin = markBricks.w + number * kMarkSlot;
    int corner = (inside.z * kMarkSide + inside.y) * kMarkSide + inside.x;
    vec4 sum = vec4(0.0);
    float covered = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 offset = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        int texel = corner + (offset.z * kMarkSide + offset.y) * kMarkSide + offset.x;
        uint colour = markWords[begin + texel];
        uint coverage = markWords[begin + kMarkColours + texel / 4] >> (8 * (texel & 3)) & 0xffu;
        vec3 w = mix(1.0 - part, part, vec3(offset));
        float weight = w.x * w.y * w.z * float(coverage) / 255.0;
        sum += weight * unpackUnorm4x8(colour);
        covered += weight;
    }
    float pixelTexels = pixelSteps * markPerVoxel.x * spacing.w / spacing.x;
    float slope = max(kMarkRamp / max(pixelTexels, 0.25), 1.0);
    float shown = clamp((covered - 0.5) * slope + 0.5, 0.0, 1.0);
    sum /= max(covered, 1e-6);
    return vec4(linearFromDisplay(sum.rgb), sum.a * shown);
}

// Linear colour and opacity of what is marked at p, seen by pixels so many steps wide: edges are as sharp as
// these, however near one goes.
vec4 markAt(vec3 p, float pixelSteps) {
    vec3 q = max((p + 0.5) * markPerVoxel.xyz - 0.5, vec3(0.0));
    ivec3 first = ivec3(floor(q));
    vec3 part = q - vec3(first);
    ivec3 brick = min(first / kMarkBrick, markBricks.xyz - 1);
    uint page = markWords[(brick.z * markBricks.y + brick.y) * markBricks.x + brick.x];
    vec4 mark = vec4(0.0);
    bool isLookedUp = page != 0u; // a loop: software renderers leave it where no ray of a group needs it
    while (isLookedUp) {
        mark = markInBrick(int(page) - 1, first - brick * kMarkBrick, part, pixelSteps);
        isLookedUp = false;
    }
    return mark;
}
