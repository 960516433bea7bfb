// Samples a row of two texels at 64 places between their centres.
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler3D values;
layout(std430, binding = 0) writeonly buffer Samples { float samples[]; };
void main() {
    float between = (float(gl_GlobalInvocationID.x) + 0.5) / 64.0;
    samples[gl_GlobalInvocationID.x] = textureLod(values, vec3(0.25 + 0.5 * between, 0.5, 0.5), 0.0).r;
}
