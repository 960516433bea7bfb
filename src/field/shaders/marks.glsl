// The colours that a person has laid on the material (field/marks/marks.h). Texture 16, uniform block 5
// (field::MarkTexture). Include "field/shaders/scene.glsl" and what has linearFromDisplay() first.

#include "field/shaders/bindings.glsl"
layout(std140, binding = kMarksBlock) uniform MarksBlock {
    ivec4 markBricks;  // xyz bricks along each axis, w where they begin in markWords
    vec4 markPerVoxel; // xyz texels along each axis of a voxel, w of a step
};
// For each brick 0, or its number counted from 1; then the bricks: the colours of their texels and of the
// first ones behind them, and for each cell (and, along z, one more) the coverage of its four corners with
// the lesser z.
layout(binding = kMarksTexture) uniform usamplerBuffer markWords;

const int kMarkShift = 4; // a brick is 1 << this texels wide
const int kMarkBrick = 1 << kMarkShift;
const int kMarkSide = kMarkBrick + 1;
const int kMarkColours = kMarkSide * kMarkSide * kMarkSide;
const int kMarkSlot = kMarkColours + kMarkBrick * kMarkBrick * kMarkSide; // words of a brick
const float kMarkRamp = 3.0; // texels, about a mark's edge, over which coverage grows from 0 to 1

vec4 wordAsBytes(int i) { return unpackUnorm4x8(texelFetch(markWords, i).r); }

// Linear colour and opacity in the cell behind a texel of the brick that begins there, seen by pixels so many
// texels wide.
vec4 markInCell(int begin, ivec3 texel, vec3 part, float pixelTexels) {
    int quad = begin + kMarkColours + (((texel.z << kMarkShift) + texel.y) << kMarkShift) + texel.x;
    vec4 across = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(vec2(1.0 - part.y), vec2(part.y));
    vec4 front = wordAsBytes(quad) * across * (1.0 - part.z);
    vec4 back = wordAsBytes(quad + kMarkBrick * kMarkBrick) * across * part.z;
    float covered = dot(front + back, vec4(1.0));
    float slope = max(kMarkRamp / max(pixelTexels, 0.25), 1.0);
    float shown = clamp((covered - 0.5) * slope + 0.5, 0.0, 1.0);
    vec4 mark = vec4(0.0);
    bool isSeen = shown > 0.0; // most cells of a brick are beside its marks
    while (isSeen) {
        int first = begin + (texel.z * kMarkSide + texel.y) * kMarkSide + texel.x;
        int behind = first + kMarkSide * kMarkSide;
        mat4 colours = mat4(wordAsBytes(first), wordAsBytes(first + 1), wordAsBytes(first + kMarkSide),
                            wordAsBytes(first + kMarkSide + 1));
        mat4 coloursBehind = mat4(wordAsBytes(behind), wordAsBytes(behind + 1),
                                  wordAsBytes(behind + kMarkSide), wordAsBytes(behind + kMarkSide + 1));
        vec4 mean = (colours * front + coloursBehind * back) / covered;
        mark = vec4(linearFromDisplay(mean.rgb), mean.a * shown);
        isSeen = false;
    }
    return mark;
}

// Linear colour and opacity of what is marked at p, seen by pixels so many steps wide: edges are as sharp as
// these, however near one goes.
vec4 markAt(vec3 p, float pixelSteps) {
    vec3 last = vec3(dims.xyz) * markPerVoxel.xyz - 1.0;
    vec3 q = clamp((p + 0.5) * markPerVoxel.xyz - 0.5, vec3(0.0), last);
    ivec3 first = ivec3(floor(q));
    vec3 part = q - vec3(first);
    ivec3 brick = first >> kMarkShift;
    int place = (brick.z * markBricks.y + brick.y) * markBricks.x + brick.x;
    uint page = texelFetch(markWords, place).r;
    vec4 mark = vec4(0.0);
    bool isLookedUp = page != 0u; // a loop: software renderers leave it where no ray of a group needs it
    while (isLookedUp) {
        int begin = markBricks.w + (int(page) - 1) * kMarkSlot;
        mark = markInCell(begin, first & (kMarkBrick - 1), part, pixelSteps * markPerVoxel.w);
        isLookedUp = false;
    }
    return mark;
}
