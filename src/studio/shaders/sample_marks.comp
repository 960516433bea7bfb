// Asks for the colours of marks at places, for the check of a device (studio/selfcheck).
// In: the scene with its marks; storage 0 places in voxel space. Out: storage 1 linear colour and opacity.
// variants: VS_PLAIN=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/shading.glsl"
#include "field/shaders/marks.glsl"
#include "studio/shaders/bindings.glsl"

layout(std430, binding = kQueriesStorage) readonly buffer Places { vec4 places[]; };
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { vec4 answers[]; };

uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) {
        answers[i] = markAt(places[i].xyz, 1.0 / markPerVoxel.w); // pixels as wide as texels
    }
}
