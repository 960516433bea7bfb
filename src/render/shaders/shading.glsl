// Light and colour. World-space unit vectors; colours linear unless said otherwise.

vec3 displayFromLinear(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 linearFromDisplay(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

// Sky light in a cavity of this colour that is `open` to the sky: what comes in goes on from wall to wall.
vec3 skyLight(float open, vec3 albedo) { return vec3(open) / (1.0 - albedo * (1.0 - open)); }

// Studio light fixed to the viewer: a warm key from the upper left, a cool fill from the right, a little
// light from the sky; Blinn-Phong highlights. `right`, `up`, `back` are the viewer's unit axes. `reaching`: x
// the part of the key light that comes here, y of the sky's and the fill's (1: nothing in the way).
vec3 lit(vec3 albedo, vec3 normal, vec3 towardsViewer, vec3 right, vec3 up, vec3 back, float gloss,
         vec2 reaching) {
    vec3 key = normalize(-0.45 * right + 0.65 * up + 0.75 * back);
    vec3 fill = normalize(0.8 * right + 0.05 * up + 0.5 * back);
    // The key is a broad lamp too: some of what hides the sky hides a part of it.
    float keyLight = max(dot(normal, key), 0.0) * reaching.x * (0.45 + 0.55 * reaching.y);
    float fillLight = max(dot(normal, fill), 0.0);
    float sky = 0.5 + 0.5 * dot(normal, up);
    vec3 around =
        0.20 * fillLight * vec3(0.85, 0.92, 1.0) + mix(vec3(0.07, 0.065, 0.06), vec3(0.16, 0.17, 0.18), sky);
    vec3 light = 0.80 * keyLight * vec3(1.0, 0.97, 0.92) + around * skyLight(reaching.y, albedo);
    float highlight = pow(max(dot(normal, normalize(key + towardsViewer)), 0.0), 40.0);
    return albedo * light + gloss * highlight * reaching.x * vec3(1.0, 0.98, 0.95);
}

vec3 lit(vec3 albedo, vec3 normal, vec3 towardsViewer, vec3 right, vec3 up, vec3 back, float gloss) {
    return lit(albedo, normal, towardsViewer, right, up, back, gloss, vec2(1.0));
}

// What is behind the volume (render::Background): display colours.
vec3 background(vec2 pixel, vec2 size, vec3 top, vec3 bottom) {
    return mix(top, bottom, smoothstep(0.0, 1.0, pixel.y / size.y));
}

// The brightest that rays of light are seen against: the studio's background at its brightest. On a lighter
// one the grid's box is as dark as this, as a film on a light table; white rays on white would show nothing.
vec3 behindFilm(vec3 behind, bool inBox) { return inBox ? min(behind, vec3(0.17, 0.19, 0.22)) : behind; }
