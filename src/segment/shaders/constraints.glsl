// Whether growth may enter a voxel. Set by segment::bindConstraints.
// Spaces: voxel indices. Bindings: texture 0 data, texture 1 sculpture (with VS_FENCED), uniforms 20 to 23.

layout(binding = 0) uniform sampler3D dataTexture;
layout(location = 20) uniform ivec3 dims;
layout(location = 21) uniform vec3 valueScale; // x scale, y offset, z 1 if values are whole numbers
layout(location = 22) uniform vec2 valueRange; // closed, in the volume's unit
#ifdef VS_FENCED
layout(binding = 1) uniform sampler3D sculptureTexture;
layout(location = 23) uniform int keepsCutPart; // 1: only where the sculpture is >= 0.5; 0: only where it is < 0.5
#endif

bool isInside(ivec3 voxel) {
    // As unsigned numbers, negative coordinates are too large as well.
    return all(lessThan(uvec3(voxel), uvec3(dims)));
}

// The voxel must be inside the grid.
bool isAdmissible(ivec3 voxel) {
    float value = texelFetch(dataTexture, voxel, 0).r * valueScale.x + valueScale.y;
    value = valueScale.z > 0.5 ? round(value) : value;
    bool admissible = value >= valueRange.x && value <= valueRange.y;
#ifdef VS_FENCED
    admissible = admissible && (texelFetch(sculptureTexture, voxel, 0).r >= 0.5) == (keepsCutPart == 1);
#endif
    return admissible;
}

ivec3 voxelOf(uint index) {
    uvec3 size = uvec3(dims);
    return ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y));
}

uint indexOf(ivec3 voxel) { return (uint(voxel.z) * uint(dims.y) + uint(voxel.y)) * uint(dims.x) + uint(voxel.x); }
