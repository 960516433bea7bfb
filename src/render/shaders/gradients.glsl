// The gradient magnitudes that transfer functions go by (TF_KIND 1 and 2). Include "field/shaders/scene.glsl"
// and "render/shaders/classification.glsl" first. TF_GRADIENTS: those of all voxels are kept in texture 10, 1
// as texels, 2 as quads.

#if defined(TF_KIND) && TF_KIND != 0
#if defined(TF_GRADIENTS) && !defined(TRICUBIC) && !defined(FINER)
// Between voxel centres that of the voxels around, as histograms count it.
#if TF_GRADIENTS == 2
layout(binding = kGradientsTexture) uniform samplerBuffer gradientQuads;
float scanGradientAt(vec3 p) { return ofQuads(gradientQuads, p) * lightingOfFunction.w; }
#else
layout(binding = kGradientsTexture) uniform sampler3D gradientTexture;
float scanGradientAt(vec3 p) {
    return textureLod(gradientTexture, textureFromVoxel(p), 0.0).r * lightingOfFunction.w;
}
#endif
#else
// With tricubic sampling, of a finer level than the scene's, and where the device has no room for all of
// them, that of the data at p.
float scanGradientAt(vec3 p) { return length(dataGradient(p)); }
#endif

#ifdef FILLED
// At the border of material, of the step from the scan's value to its own.
DEFINE_GRADIENT(stepOfFill, filledByAny)
float gradientAt(vec3 p) {
    float filled = filledByAny(p);
    float gradient = scanGradientAt(p);
    bool isFilled = filled >= 0.5;
    while (isFilled) {
        gradient = length(stepOfFill(p)) * abs(dataAt(p) - scanAt(p));
        isFilled = false;
    }
    return gradient;
}
#else
float gradientAt(vec3 p) { return scanGradientAt(p); }
#endif
#endif
