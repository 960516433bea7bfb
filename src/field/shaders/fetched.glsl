// Trilinear samples that are the same to the last bit wherever in a texture the texels lie, and however the
// texture stores them: a texture unit rounds the place that it is given, and so the weights, and a sum of
// texels is rounded otherwise than one of what they stand for. For what decides between one thing and
// another. Included by scene.glsl.

// What texels stand for: texel * scale + offset, which are whole numbers, or not.
struct Meaning {
    vec2 scale; // x scale, y offset
    bool isWhole;
};
const Meaning kThemselves = Meaning(vec2(1.0, 0.0), false);

vec4 meant(vec4 texels, Meaning meaning) {
    vec4 values = texels * meaning.scale.x + meaning.scale.y;
    return meaning.isWhole ? round(values) : values;
}

// Between the texels `first` and `next`, which lie one texel apart along each axis, or are the same one.
float fetchedBetween(sampler3D texels, ivec3 first, ivec3 next, vec3 f, Meaning meaning) {
    vec4 low = vec4(texelFetch(texels, first, 0).r, texelFetch(texels, ivec3(next.x, first.yz), 0).r,
                    texelFetch(texels, ivec3(first.x, next.y, first.z), 0).r,
                    texelFetch(texels, ivec3(next.xy, first.z), 0).r);
    vec4 high = vec4(texelFetch(texels, ivec3(first.xy, next.z), 0).r,
                     texelFetch(texels, ivec3(next.x, first.y, next.z), 0).r,
                     texelFetch(texels, ivec3(first.x, next.yz), 0).r, texelFetch(texels, next, 0).r);
    vec4 planes = mix(meant(low, meaning), meant(high, meaning), f.z);
    vec2 rows = mix(planes.xy, planes.zw, f.y);
    return mix(rows.x, rows.y, f.x);
}

// At a place in the voxel space of a grid that has all of a texture; beyond it, what is at its border.
float fetchedOfAll(sampler3D texels, vec3 q, ivec3 size, Meaning meaning) {
    ivec3 last = size - 1;
    vec3 inside = clamp(q, vec3(0.0), vec3(last));
    ivec3 first = ivec3(inside);
    return fetchedBetween(texels, first, min(first + 1, last), inside - vec3(first), meaning);
}
