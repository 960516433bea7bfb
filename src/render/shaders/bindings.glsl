// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here. Numbers of one kind that one program uses differ; programs that
// do not meet share them.

// Texture units.
const int kDataCellsTexture = 0;
const int kPlanesBeforeTexture = 0;
const int kPlanesTexture = 0;
const int kRangesTexture = 0;
const int kSculptureCellsTexture = 1;
const int kSegmentationCellsTexture = 2;
const int kCellDistancesTexture = 3;
const int kDataCellRangesTexture = 4;
const int kFunctionTableTexture = 5;
const int kFilledCellsTexture = 6; // where no quads are
const int kVisibleBeforeTexture = 7;
const int kBeamsTexture = 8;
const int kGradientCellsTexture = 8;
const int kOcclusionTexture = 9;
const int kFunctionSpansTexture = 10;
const int kGradientsTexture = 10; // functions of values alone have spans, others gradients
const int kSegmentCellDistancesTexture = 11;
const int kSlabListsTexture = 11;
const int kCellTopsTexture = 12;

// Image units.
const int kAccumulationImage = 0;
const int kAveragesImage = 0;
const int kBeamsImage = 0;
const int kDilatedImage = 0;
const int kDistancesImage = 0;
const int kListsImage = 0;
const int kOcclusionImage = 0;
const int kSlicePictureImage = 0;
const int kTopsImage = 0;
const int kPictureImage = 1;
const int kSeenFrontImage = 1;
const int kSeenBehindImage = 2;
const int kSeenGlassImage = 3;
const int kSeenGlassDepthImage = 4;
const int kRoundsImage = 5;

// Storage blocks.
const int kPlanesStorage = 0;
const int kOtherPlaneStorage = 1;
const int kPositionsStorage = 0;
const int kSquaresStorage = 0;
const int kSquareCountsStorage = 1;
const int kPointsStorage = 1;
const int kPlacesStorage = 2;
const int kContrastsStorage = 3;
const int kOrderedStorage = 4;
const int kMarksStorage = 5;

// Uniform blocks.
const int kViewBlock = 1;
const int kClassificationBlock = 2;
const int kOcclusionBlock = 3;
const int kSegmentColoursBlock = 7;
