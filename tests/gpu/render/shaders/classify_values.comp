// Asks the transfer function's tables. In: storage 0 queries (value, gradient magnitude or second value).
// Out: storage 1 per query classify(); whether what lies between two values may be visible (x), and whether a
// value may be with a gradient magnitude up to the second number (y); classifySpan().
layout(local_size_x = 64) in;

#include "render/shaders/classification.glsl"

layout(std430, binding = 0) readonly buffer Queries { vec2 queries[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) {
        return;
    }
    vec2 query = queries[i];
    answers[3 * i] = classify(query.x, query.y);
    answers[3 * i + 1] = vec4(mayBeVisible(query.x, query.y) ? 1.0 : 0.0,
                              mayBeVisible(query.x, query.x, query.y) ? 1.0 : 0.0, 0.0, 0.0);
#if TF_KIND == 0
    answers[3 * i + 2] = classifySpan(columnOf(query.x), columnOf(query.y));
#else
    answers[3 * i + 2] = vec4(0.0);
#endif
}
