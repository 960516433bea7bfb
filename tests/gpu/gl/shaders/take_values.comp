// Takes a number in one of several ways and adds it to storage 2.
layout(local_size_x = 1) in;
#if FROM == 0
layout(r32ui, binding = 0) uniform readonly uimage3D texels;
uint taken() { return imageLoad(texels, ivec3(0)).x; }
#elif FROM == 6
layout(r32ui, binding = 0) uniform uimage3D texels;
uniform int stores; // 0 in the tests, which a compiler does not know
uint taken() {
    if (stores != 0) {
        imageStore(texels, ivec3(1), uvec4(1u));
    }
    return imageLoad(texels, ivec3(0)).x;
}
#elif FROM == 1
layout(binding = 0) uniform usampler3D texels;
uint taken() { return texelFetch(texels, ivec3(0), 0).x; }
#elif FROM == 2
layout(std430, binding = 0) readonly buffer Values { uint values[]; };
uint taken() { return values[0]; }
#elif FROM == 3
layout(binding = 0) uniform usamplerBuffer texels;
uint taken() { return texelFetch(texels, 0).x; }
#elif FROM == 4
layout(std140, binding = 0) uniform Number { uint number; };
uint taken() { return number; }
#else
uint taken() { return 1u; }
#endif
layout(std430, binding = 2) buffer Answers { uint answers[]; };

void main() { atomicAdd(answers[0], taken()); }
