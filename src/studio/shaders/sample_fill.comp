// Asks how much places are filled and with what, for the check of a device (studio/selfcheck).
// In: the scene with its fill; storage 0 places in voxel space. Out: storage 1 how much by anything (x) and
// by what is seen (y), the material (z), the value there (w).
// variants: FILLED=1;FILLED=2
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "studio/shaders/bindings.glsl"

layout(std430, binding = kQueriesStorage) readonly buffer Places { vec4 places[]; };
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) {
        vec3 p = places[i].xyz;
        answers[i] = vec4(filledAt(p), float(materialAt(p, true)), dataAt(p));
    }
}
