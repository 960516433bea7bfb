// Squares of 8 x 8 pixels, those that may show something first: one work group of 64 invocations each.
// Bindings: storage 0 the squares (list_squares.comp), image 0 (rgba32f) sums of display colours and coverage; uniforms 0 to 2. Include
// "render/shaders/rays.glsl" first.

layout(std430, binding = 0) readonly buffer Squares { uint squares[]; }; // column, row << 16

layout(rgba32f, binding = 0) uniform image2D accumulation;

layout(location = 0) uniform ivec3 run;       // of the list: x first square, y how many, z strands
layout(location = 1) uniform vec2 pixelOffset; // where in the pixel this sample lies, 0..1
layout(location = 2) uniform int addToPrevious;

const ivec2 kNowhere = ivec2(1 << 30);

// Eight invocations after one another are 4 x 2 pixels, 16 are 4 x 4: their rays stay together. Work groups take turns in as
// many strands as there are workers, as a software renderer gives each worker one piece of their sequence: so all pieces
// take as long.
ivec2 pixelOfInvocation() {
    int perStrand = (run.y + run.z - 1) / run.z;
    int group = int(gl_WorkGroupID.x);
    int index = (group % perStrand) * run.z + group / perStrand;
    uint square = squares[run.x + min(index, run.y - 1)];
    int i = int(gl_LocalInvocationIndex);
    ivec2 inSquare = ivec2((i & 3) + ((i >> 2) & 4), ((i >> 2) & 3) + ((i >> 3) & 4));
    ivec2 pixel = 8 * ivec2(square & 0xffffu, square >> 16) + inSquare;
    return index < run.y ? pixel : kNowhere;
}

// Display colour and coverage.
void addToPicture(ivec2 pixel, vec4 sum) {
    if (addToPrevious != 0) {
        sum += imageLoad(accumulation, pixel);
    }
    imageStore(accumulation, pixel, sum);
}
