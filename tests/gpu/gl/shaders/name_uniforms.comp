// Adds to each of three taps the offset. Out: storage 0. The uniform `unused` is declared, and no more.
layout(local_size_x = 3) in;

uniform float offset;
uniform float taps[3];
uniform int unused;
layout(std140, binding = 0) uniform Block { float inBlock; };
layout(std430, binding = 0) writeonly buffer Answers { float answers[]; };

void main() { answers[gl_LocalInvocationID.x] = taps[gl_LocalInvocationID.x] + offset; }
