// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here. Numbers of one kind that one program uses differ; programs that
// do not meet share them.

// Texture units.
const int kDataTexture = 0;
const int kSectionTexture = 0;
const int kSourceTexture = 0;
const int kTexelsTexture = 0;
const int kValuesTexture = 0;
const int kSculptureTexture = 1;
const int kSegmentationTexture = 2;
const int kBrickSegmentsTexture = 4; // not where maxima are looked for
const int kQuadsTexture = 6;
const int kBrickPagesTexture = 6; // of bricks there are no quads
const int kApartTilesTexture = 7;
const int kSmoothedQuadsTexture = 12;
const int kBrickPoolTexture = 12; // nor smoothed values
const int kSegmentLabelsTexture = 13;
const int kApartPagesTexture = 15; // of a segment, whose surfaces are not looked for in smoothed values
const int kBrickCutsTexture = 15;  // not where a segment is drawn apart from others
const int kSmoothedTexture = 15;
const int kMarksTexture = 16;
const int kFillTexture = 17;

// Image units.
const int kCellsImage = 0;
const int kQuadsImage = 0;
const int kTargetImage = 0;

// Storage blocks.
const int kCountsStorage = 0;
const int kBrickUsesStorage = 6;

// Uniform blocks.
const int kSceneBlock = 0;
const int kBricksBlock = 4;
const int kMarksBlock = 5;
const int kFillBlock = 6;
