// A uniform block with a member of each kind, and one that std140 does not lay out as C++ does. Out: storage
// 0.
layout(local_size_x = 1) in;
layout(std140, binding = 0) uniform MixedBlock {
    vec4 place;
    mat4 turn;
    ivec4 counts[2];
    float loose[4]; // 16 bytes each
};
layout(std430, binding = 0) writeonly buffer Answer { vec4 answer; };

void main() { answer = turn * place + vec4(counts[1]) + loose[3]; }
