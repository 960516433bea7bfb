// Asks the scene for the data's value and gradient at places, for the check of a device (studio/selfcheck).
// In: the scene; storage 0 places in voxel space. Out: storage 1 gradient (xyz), value (w).
// variants: VS_PLAIN=1;QUADS=1;TRICUBIC=1;QUADS=1 TRICUBIC=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "studio/shaders/bindings.glsl"

layout(std430, binding = kQueriesStorage) readonly buffer Places { vec4 places[]; };
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) {
        answers[i] = vec4(dataGradient(places[i].xyz), dataAt(places[i].xyz));
    }
}
