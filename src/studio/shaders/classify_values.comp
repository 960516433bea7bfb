// Asks the transfer function's tables, for the check of a device (studio/selfcheck). In: storage 0 queries,
// each a value (x) and a gradient magnitude (y). Out: storage 1 classify() of each.
// variants: TF_KIND=0;TF_KIND=1;TF_KIND=2
layout(local_size_x = 64) in;

#include "render/shaders/classification.glsl"
#include "studio/shaders/bindings.glsl"

layout(std430, binding = kQueriesStorage) readonly buffer Queries { vec4 queries[]; };
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) {
        answers[i] = classify(queries[i].x, queries[i].y);
    }
}
