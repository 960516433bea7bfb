// Where an invocation of a shader works that Program::dispatchOver runs: what would keep a device busy for
// long is submitted in layers (gl/dispatch_pace.h). Include after the local size is declared.
uniform ivec3 firstPlace; // of the layers that are submitted now

ivec3 placeOfInvocation() { return firstPlace + ivec3(gl_GlobalInvocationID); }
