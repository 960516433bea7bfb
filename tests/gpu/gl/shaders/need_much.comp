// Needs more than every device has. It is compiled, and never run.
layout(local_size_x = 1) in;
layout(r32f, binding = 8) uniform writeonly image2D target;
layout(std430, binding = 0) writeonly buffer B0 { uint b0[]; };
layout(std430, binding = 1) writeonly buffer B1 { uint b1[]; };
layout(std430, binding = 2) writeonly buffer B2 { uint b2[]; };
layout(std430, binding = 3) writeonly buffer B3 { uint b3[]; };
layout(std430, binding = 4) writeonly buffer B4 { uint b4[]; };
layout(std430, binding = 5) writeonly buffer B5 { uint b5[]; };
layout(std430, binding = 6) writeonly buffer B6 { uint b6[]; };
layout(std430, binding = 8) writeonly buffer B8 { uint b8[]; };
uniform uint word;
void main() {
    b0[0] = word;
    b1[0] = word;
    b2[0] = word;
    b3[0] = word;
    b4[0] = word;
    b5[0] = word;
    b6[0] = word;
    b8[0] = word;
    imageStore(target, ivec2(0), vec4(1.0));
}
