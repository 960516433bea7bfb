// Asks how much light reaches places. In: storage 0 queries, two vec4 each: voxel, normal (world).
// Out: storage 1 per query ambientAt(), lightReaching(), cheapLight().
layout(local_size_x = 64) in;

#include "render/shaders/occlusion.glsl"

layout(std430, binding = 0) readonly buffer Queries { vec4 queries[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) {
        return;
    }
    vec3 voxel = queries[2 * i].xyz;
    vec3 normal = queries[2 * i + 1].xyz;
    answers[i] = vec4(ambientAt(voxel, normal), lightReaching(voxel, normal), cheapLight(voxel, normal));
}
