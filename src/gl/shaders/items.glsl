// The item of a list that an invocation works on, for shaders run by Program::dispatchOverList: long lists
// are folded into rows of groups. Include after the local size is declared; items beyond the list's end must
// be left alone.
uint itemIndex() {
    return gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
}
