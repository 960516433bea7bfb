// Trilinear samples of what is kept in quads (field/quads.h): what a texture unit would do, for renderers
// without one. Included by scene.glsl.

// The stored value at p, 0 to 1 for whole numbers. Beyond the grid values are those at its border. Voxel
// space.
float ofQuads(samplerBuffer source, vec3 p) {
    vec3 inside = clamp(p, vec3(0.0), vec3(dims.xyz - 1));
    ivec3 voxel = ivec3(inside);
    vec3 f = inside - vec3(voxel);
    int place = (voxel.z * dims.y + voxel.y) * dims.x + voxel.x;
    int above = place + (voxel.z + 1 < dims.z ? dims.x * dims.y : 0);
    vec4 four = mix(texelFetch(source, place), texelFetch(source, above), f.z);
    vec2 two = mix(four.xy, four.zw, f.y);
    return mix(two.x, two.y, f.x);
}
