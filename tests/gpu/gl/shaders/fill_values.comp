// Writes 7 to image 0, or to storage 0. Storage 1 is declared, and no more.
layout(local_size_x = 1) in;
#ifdef TO_IMAGE
layout(r32ui, binding = 0) uniform writeonly uimage3D texels;
#else
layout(std430, binding = 0) writeonly buffer Values { uint values[]; };
#endif
layout(std430, binding = 1) buffer Idle { uint idle[]; };

uint unused() { return idle[0]; }

void main() {
#ifdef TO_IMAGE
    imageStore(texels, ivec3(0), uvec4(7u));
#else
    values[gl_GlobalInvocationID.x] = 7u;
#endif
}
