// The values of [rayshade4/3 s.12, s.17], which came from the original.
#include "rayshade/texture/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rayshade/texture/texture.h"

namespace rayshade {
namespace {

constexpr double kTolerance = 1e-9;

struct Sample {
  Vector p;
  double noise, dnoise_y, dnoise_z, fbm_a, fbm_b, pa_chaos, marble;
};
// clang-format off
constexpr Sample kSamples[] = {
    {{0, 0, 0}, -0.033920288, -0.085937500, 0.423065186, -0.066780567, -0.053092237, 0.066780567, 0.339007688},
    {{1, 0, 0}, -0.107849121, -0.229415894, 0.150375366, 0.110482216, 0.055036979, 0.353074074, 0.911483203},
    {{0, 1, 0}, 0.225341797, -0.165603638, 0.426605225, 0.243106842, 0.349270890, 0.426280975, 0.973270675},
    {{0, 0, 1}, 0.260864258, -0.426208496, -0.129058838, 0.210990906, 0.258911721, 0.414283752, 0.871145341},
    {{-1, -1, -1}, 0.413497925, 0.255920410, -0.072601318, 0.216729164, 0.347143759, 0.610266685, 0.941949094},
    {{5, -7, 3}, 0.451766968, -0.292968750, 0.348648071, 0.524891376, 0.413171987, 0.616924763, 0.616150654},
    {{0.5, 0.5, 0.5}, 0.216384888, 0.119943619, 0.331184387, 0.314282894, 0.268884620, 0.335067272, 0.462309632},
    {{-0.5, -0.5, -0.5}, 0.064884186, -0.002315521, 0.032743454, 0.175265312, 0.168969267, 0.368000984, 0.125992659},
    {{0.25, 0.5, 0.75}, 0.167480290, 0.127753280, -0.008235786, 0.085026085, 0.028317474, 0.408512414, 0.423018142},
    {{-0.25, -0.5, -0.75}, 0.309295680, -0.255388804, 0.082333215, 0.357461002, 0.387477921, 0.431042697, 0.242365226},
    {{0.1, 0.2, 0.3}, 0.081856903, -0.179031919, 0.402787808, 0.196746137, 0.117035293, 0.217109548, 0.339862935},
    {{1.1, 2.2, 3.3}, 0.036201483, 0.441311426, 0.012988112, -0.082929977, -0.142787095, 0.240579228, 0.379965021},
    {{-1.1, -2.2, -3.3}, 0.299775436, -0.045090322, -0.061413531, 0.163863734, 0.290145445, 0.435687137, 0.493513662},
    {{10.5, 0, 0}, 0.127487183, -0.213729858, -0.385574341, 0.214217186, 0.278485305, 0.405837059, 0.996071191},
    {{0, 10.5, 0}, 0.136978149, 0.181762695, 0.647827148, 0.027538776, 0.179019086, 0.289047718, 0.682812466},
    {{0, 0, 10.5}, -0.375518799, 0.354072571, 0.145507812, -0.421397209, -0.181950689, 0.536559105, 0.941280541},
    {{0.999, 0.001, 0.5}, 0.284463852, -0.153300834, 0.092059614, 0.322906376, 0.280089308, 0.456672327, 0.494502887},
    {{-0.001, 0.001, 0}, -0.033455494, -0.085172133, 0.421282321, -0.064033832, -0.051563824, 0.064033832, 0.349086074},
    {{100.25, -50.75, 25.125}, -0.438930544, 0.035530580, 0.030622724, -0.501273039, -0.448404185, 0.592544738, 0.921004093},
    {{1000.3, 2000.6, -3000.9}, -0.321158629, -0.031986872, 0.549083764, -0.522689520, -0.326504786, 0.535444615, 0.789248756},
    {{-3.17, -4.76, -1.25}, 0.508899378, -0.106644795, -0.186079378, 0.611685102, 0.447211226, 0.721587649, 0.864559499},
    {{-4.14, -5.2, -1.18}, -0.386671358, -0.052416725, -0.069691389, -0.471713468, -0.248422534, 0.694741078, 0.804522204},
    {{5.02, 3.61, 3.18}, 0.359083438, 0.257853714, 0.245137381, 0.151966781, 0.380970710, 0.585772196, 0.007888066},
    {{-3.34, 0.44, -2.68}, -0.001910803, -0.023912059, -0.104418549, -0.075119311, -0.129704192, 0.251202648, 0.349486865},
    {{-3.93, -4.73, -3.43}, -0.105302685, 0.422021198, -0.291123617, -0.072908094, -0.200292682, 0.178876538, 0.806927769},
    {{5.13, 3.95, 3.68}, 0.498138356, -0.107364443, -0.025417159, 0.647413573, 0.585743293, 0.648348157, 0.365516350},
    {{3.61, -3.68, -2.28}, -0.201566671, 0.088679688, 0.037078366, -0.383591884, -0.148529375, 0.493524017, 0.504159444},
    {{1.52, 2.78, 4.26}, 0.118955777, -0.469923924, -0.139192774, -0.086870975, 0.057411987, 0.344307213, 0.200578148},
    {{4.56, -4.96, 1.27}, 0.079906456, -0.104008036, -0.338660956, -0.157179997, 0.043527941, 0.340554754, 0.990587435},
    {{2.06, 0.07, -3.87}, -0.484188883, 0.258734142, 0.370911729, -0.640520110, -0.705892682, 0.769803859, 0.222389875},
    {{-0.32, -4.93, 5.22}, -0.538809007, 0.166586008, -0.014086789, -0.172161433, -0.628274498, 0.907265162, 0.306773733},
    {{4.39, 0.57, -2.4}, 0.175606903, 0.190400112, 0.137815564, 0.130286701, 0.144177572, 0.244256696, 0.608743460},
    {{4.91, 0.87, 4.59}, -0.006055233, 0.090426946, 0.088399257, 0.211203701, 0.088734320, 0.234652302, 0.871453846},
    {{4.18, 0.1, -1.03}, -0.294194872, 0.404243304, 0.346833845, -0.222095764, -0.322472843, 0.476267063, 0.383399038},
    {{1.19, -0.83, -4.06}, -0.151468209, -0.335646923, 0.144819785, -0.302343510, -0.336346886, 0.360117751, 0.820021075},
    {{-2.34, 3.75, -5.48}, -0.003613714, -0.331881964, 0.141434328, -0.019692055, 0.013457432, 0.081220798, 0.213929218},
    {{-5.44, 1.52, -2.63}, 0.453504130, -0.043817594, 0.025843930, 0.711095599, 0.298411608, 0.728857104, 0.515447819},
    {{0.42, -0.35, -1.89}, 0.091498079, 0.132424808, 0.069828401, 0.055839213, 0.002730646, 0.161011731, 0.486590245},
    {{5.97, -3.65, -1.05}, -0.321876996, 0.677066668, -0.132521394, -0.296440331, -0.189622829, 0.458530976, 0.714471340},
    {{-3.57, 1.59, -2.68}, -0.113770171, 0.027477887, 0.305057172, -0.120478651, -0.018432006, 0.247227623, 0.190967625},
};

struct VectorSample {
  Vector p, vfbm;
};
constexpr VectorSample kVectorSamples[] = {
    {{0.5, 0.5, 0.5}, {0.268884620, 0.137430381, 0.334332515}},
    {{-0.5, -0.5, -0.5}, {0.168969267, 0.022595117, -0.005801765}},
    {{0.25, 0.5, 0.75}, {0.028317474, 0.367618438, 0.080934300}},
    {{-0.25, -0.5, -0.75}, {0.387477921, -0.297260236, 0.111469659}},
    {{0.1, 0.2, 0.3}, {0.117035293, -0.075382835, 0.454137250}},
    {{1.1, 2.2, 3.3}, {-0.142787095, 0.367850806, 0.218042950}},
    {{-0.32, -4.93, 5.22}, {-0.628274498, 0.207980132, 0.055618096}},
    {{4.39, 0.57, -2.4}, {0.144177572, 0.168240489, 0.041178158}},
    {{4.91, 0.87, 4.59}, {0.088734320, -0.011664170, 0.032498413}},
    {{4.18, 0.1, -1.03}, {-0.322472843, 0.558809857, 0.419537267}},
};
// clang-format on

TEST(Noise, TablesHaveTheDocumentedEntriesAndSums) {
  const NoiseTables& tables = GetNoiseTables();
  const int crcs[] = {0, 25938, 21871, 60927, 50535, 37809, 7652, 34394, 13692, 27800, 953, 37117};
  for (int i = 0; i < 12; ++i) EXPECT_EQ(tables.random[i], crcs[i] * 2.0 / 65536 - 1) << i;
  EXPECT_EQ(tables.random[266], -0.757080078125);
  double sum = 0;
  for (double r : tables.random) sum += r;
  EXPECT_EQ(sum, -3.697052001953125);

  const int first[] = {2682, 395,  1334, 1921, 537, 217,  1855, 1283,
                       605,  1305, 3607, 3664, 795, 1388, 1546, 2346};
  for (int i = 0; i < 16; ++i) EXPECT_EQ(tables.shuffle[i], first[i]) << i;
  int64_t check = 0;
  for (int64_t i = 0; i < 4096; ++i) check += (i + 1) * tables.shuffle[i];
  EXPECT_EQ(check % 65521, 14578);
}

TEST(Noise, AgreesWithTheOriginalAtAllSamples) {
  const double omega_b = OmegaOf(.8, 2.17);
  EXPECT_NEAR(omega_b, 0.3652601944645352, 1e-15);
  for (const Sample& s : kSamples) {
    SCOPED_TRACE(testing::Message() << s.p.x << " " << s.p.y << " " << s.p.z);
    EXPECT_NEAR(Noise(s.p), s.noise, kTolerance);
    const Vector d = DNoise(s.p);
    EXPECT_NEAR(d.x, s.noise, kTolerance);
    EXPECT_NEAR(d.y, s.dnoise_y, kTolerance);
    EXPECT_NEAR(d.z, s.dnoise_z, kTolerance);
    EXPECT_NEAR(Fbm(s.p, OmegaOf(.5, 2), 2, 6), s.fbm_a, kTolerance);
    EXPECT_NEAR(Chaos(s.p, 6), s.fbm_a, kTolerance);
    EXPECT_NEAR(Fbm(s.p, omega_b, 2.17, 5), s.fbm_b, kTolerance);
    EXPECT_NEAR(PAChaos(s.p, 6), s.pa_chaos, kTolerance);
  }
}

TEST(Noise, VectorSumAgreesWithTheOriginalAtAllSamples) {
  for (const VectorSample& s : kVectorSamples) {
    SCOPED_TRACE(testing::Message() << s.p.x << " " << s.p.y << " " << s.p.z);
    const Vector v = VectorFbm(s.p, OmegaOf(.8, 2.17), 2.17, 5);
    EXPECT_NEAR(v.x, s.vfbm.x, kTolerance);
    EXPECT_NEAR(v.y, s.vfbm.y, kTolerance);
    EXPECT_NEAR(v.z, s.vfbm.z, kTolerance);
  }
}

TEST(Marble, VeinsAgreeWithTheOriginalAtAllSamples) {
  const auto marble = MakeTexture({MarbleSpec{}, {}}, {});
  for (const Sample& s : kSamples) {
    TextureHit hit;
    hit.point = s.p;
    hit.surface.diffuse = {1, .5, 0};
    marble->Apply(&hit);
    EXPECT_NEAR(hit.surface.diffuse.r, s.marble, kTolerance);
    EXPECT_NEAR(hit.surface.diffuse.g, .5 * s.marble, kTolerance);
    EXPECT_EQ(hit.surface.diffuse.b, 0);
  }
}

TEST(Noise, HasPeriod4096InEachDirection) {
  const Vector p{1.5, -2.25, 3.75};
  EXPECT_NEAR(Noise(p + Vector{4096, 0, 0}), Noise(p), 1e-12);
  EXPECT_NEAR(Noise(p + Vector{0, -4096, 0}), Noise(p), 1e-12);
  EXPECT_NEAR(Noise(p + Vector{0, 0, 8192}), Noise(p), 1e-12);
}

TEST(Noise, IsDefinedBeyondTheRangeOfIntegers) {
  const double inf = std::numeric_limits<double>::infinity();
  for (double far : {3e9, -3e9, 1e14, -1e14, 1e300, inf, -inf, std::nan("")}) {
    const double n = Noise({far, far, 0.5});
    EXPECT_LE(std::abs(n), 1000) << far;
    EXPECT_EQ(n, Noise({far, far, 0.5})) << far;
  }
  // A whole number of periods away from a representable point in range.
  const double many = 4096.0 * (1 << 20);
  EXPECT_EQ(Noise({many, 0, 0}), Noise({0, 0, 0}));
}

// Every octave, however little it adds.
double PlainFbm(Vector p, double omega, double lambda, int octaves) {
  double sum = 0, amplitude = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * Noise(p);
    amplitude *= omega;
    p = lambda * p;
  }
  return sum;
}

TEST(Noise, SumsEndWhereFurtherOctavesCannotChangeABit) {
  constexpr int kMany = 2000000000;
  for (const Vector& p : {Vector{1, 2, 3}, {.1, -.7, 2.3}, {1e-9, 0, 0}, {-1e7, 3e9, .5}}) {
    EXPECT_EQ(Fbm(p, .5, 2, kMany), PlainFbm(p, .5, 2, 2000));
    EXPECT_EQ(Fbm(p, .9, 2.17, kMany), PlainFbm(p, .9, 2.17, 9000));
    EXPECT_EQ(Fbm(p, -.97, 1, kMany), PlainFbm(p, -.97, 1, 30000));
    EXPECT_TRUE(std::isfinite(Fbm(p, 1.5, 2, kMany)));
  }
}

TEST(Noise, OnlySumsThatWouldNotEndAreLimited) {
  for (const double weight : {.5, .98, -.9, 0., 1.2, -7.}) {
    int octaves = 1000000000;
    EXPECT_FALSE(FitOctaves(weight, &octaves)) << weight;
    EXPECT_EQ(octaves, 1000000000);
  }
  for (const double weight : {1., .99, -1., 1.0001}) {
    int octaves = 1000000000, few = kOctavesMax;
    EXPECT_TRUE(FitOctaves(weight, &octaves)) << weight;
    EXPECT_EQ(octaves, kOctavesMax);
    EXPECT_FALSE(FitOctaves(weight, &few));
  }
}

TEST(Noise, NoOctavesGiveNothingAndTooManyEnd) {
  EXPECT_EQ(Fbm({1, 2, 3}, .5, 2, 0), 0);
  EXPECT_EQ(Fbm({1, 2, 3}, .5, 2, -1), 0);
  EXPECT_EQ(PAChaos({1, 2, 3}, -7), 0);
  EXPECT_EQ(VectorFbm({1, 2, 3}, .5, 2, -1), Vector{});
  EXPECT_TRUE(std::isfinite(Chaos({.1, .2, .3}, 2147483647)));
}

}  // namespace
}  // namespace rayshade
