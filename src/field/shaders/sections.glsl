// What sections show where surfaces are looked for in smoothed values: the values themselves, sampled as
// scanAt() samples the smoothed ones. Voxel space. Bindings: texture 0. Included by scene.glsl.

float storedInSection(vec3 p) { return textureLod(sectionTexture, textureFromVoxel(p), 0.0).r; }

// What a section through p shows: the data's own value.
#ifdef TRICUBIC
float sectionValueAt(vec3 p) {
    Taps taps = valueTaps(p);
    float sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        bvec3 isUpper = bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
        vec3 weight = mix(taps.weightLower, taps.weightUpper, isUpper);
        sum += weight.x * weight.y * weight.z * storedInSection(mix(taps.lower, taps.upper, isUpper));
    }
    return sum * valueScale.x + valueScale.y;
}
#else
float sectionValueAt(vec3 p) { return storedInSection(p) * valueScale.x + valueScale.y; }
#endif
