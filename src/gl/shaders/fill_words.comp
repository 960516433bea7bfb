// Gives words of a buffer one value. Out: storage 0 the buffer. Invocations take words in turns, however many
// invocations there are.
layout(local_size_x = 256) in;

#include "gl/shaders/bindings.glsl"
layout(std430, binding = kWordsStorage) writeonly buffer Words { uint words[]; };

uniform uint firstWord;
uniform uint wordCount;
uniform uint value;

void main() {
    uint step = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint n = gl_GlobalInvocationID.x; n < wordCount; n += step) {
        words[firstWord + n] = value;
    }
}
