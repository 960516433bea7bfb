// Squares of 8 x 8 pixels, those that may show something first: one work group of 64 invocations each.
// Bindings: storage 0 the squares (list_squares.comp), image 0 (rgba32f) sum of display colours and coverage; uniforms 0 to 2. Include
// "render/shaders/rays.glsl" first.

layout(std430, binding = 0) readonly buffer Squares { uint squares[]; }; // column, row << 16

layout(rgba32f, binding = 0) uniform image2D accumulation;

layout(location = 0) uniform ivec3 part;       // of the list: x first square, y how many, z strands
layout(location = 1) uniform vec2 pixelOffset; // where in the pixel this sample lies, 0..1
layout(location = 2) uniform int addToPrevious;

const float kSampleCount = 1024.0; // for each sample, in the sum of coverages: see resolve_picture.comp
const ivec2 kNowhere = ivec2(1 << 30);

// Eight invocations after one another are 4 x 2 pixels, 16 are 4 x 4: their rays stay together. Work groups take turns in as
// many strands as there are workers, as a software renderer gives each worker one piece of their sequence: so all pieces
// take as long.
ivec2 pixelOfInvocation() {
    int perStrand = (part.y + part.z - 1) / part.z;
    int group = int(gl_WorkGroupID.x);
    int index = (group % perStrand) * part.z + group / perStrand;
    uint square = squares[part.x + min(index, part.y - 1)];
    int i = int(gl_LocalInvocationIndex);
    ivec2 inSquare = ivec2((i & 3) + ((i >> 2) & 4), ((i >> 2) & 3) + ((i >> 3) & 4));
    ivec2 pixel = 8 * ivec2(square & 0xffffu, square >> 16) + inSquare;
    return index < part.y ? pixel : kNowhere;
}

// Display colour, and coverage (at most 1), which is counted along with the samples.
void addToPicture(ivec2 pixel, vec4 shown) {
    vec4 sum = shown + vec4(0.0, 0.0, 0.0, kSampleCount);
    if (addToPrevious != 0) {
        sum += imageLoad(accumulation, pixel);
    }
    imageStore(accumulation, pixel, sum);
}
