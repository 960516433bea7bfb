// Asks the scene for the data's value and gradient. In: the scene; storage 0 places in voxel space.
// Out: storage 1 gradient (xyz), value (w).
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"

layout(std430, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) {
        answers[i] = vec4(dataGradient(places[i].xyz), dataAt(places[i].xyz));
    }
}
