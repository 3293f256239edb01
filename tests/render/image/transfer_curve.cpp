#include "render/image/levels/transfer_curve.h"

#include <catch2/catch.hpp>

using image::OutputCurves;
using image::output_curves;
using image::Transcoder;
using image::TransferCurve;

namespace {

constexpr double kPrinted = 6e-7;  // the expected values are known to six decimals

Approx near(double value) { return Approx(value).margin(kPrinted).epsilon(0); }

}  // namespace

TEST_CASE("an srgb colour in each working space has the value that POV-Ray prints", "[image][gamma]")
{
    const Transcoder linear(TransferCurve::linear(), TransferCurve::srgb());
    CHECK(linear.to_working(0.5f) == near(0.214041));
    CHECK(linear.to_working(0.02f) == near(0.001548));
    CHECK(linear.to_working(1.5f) == near(2.537156));
    CHECK(linear.to_working(-0.1f) == near(-0.007740));
    const Transcoder power(TransferCurve::power(2.2f), TransferCurve::srgb());
    CHECK(power.to_working(0.5f) == near(0.496227));
    CHECK(power.to_working(0.02f) == near(0.052799));
    CHECK(power.to_working(1.5f) == near(1.526842));
    CHECK(power.to_working(-0.1f) == 0.0f);
    const Transcoder same(TransferCurve::srgb(), TransferCurve::srgb());
    for (const float value : {0.5f, 0.02f, 1.5f, -0.1f}) CHECK(same.to_working(value) == value);
}

TEST_CASE("an exponent within 1 % of 1 is the identity and keeps negative values", "[image][gamma]")
{
    CHECK(TransferCurve::power(1.005f) == TransferCurve::linear());
    CHECK(TransferCurve::power(1.0f).encode(-0.25f) == -0.25f);
    CHECK(TransferCurve::power(1.02f).kind == TransferCurve::Kind::Power);
    CHECK(TransferCurve::power(1.02f).encode(-0.25f) == 0.0f);
}

TEST_CASE("two power laws become one", "[image][gamma]")
{
    const Transcoder combined(TransferCurve::power(2.2f), TransferCurve::power(1.8f));
    CHECK(combined.to_file(0.3f) == Approx(std::pow(0.3, 2.2 / 1.8)).epsilon(1e-6));
    const Transcoder nearly_equal(TransferCurve::power(2.2f), TransferCurve::power(2.205f));
    CHECK(nearly_equal.to_file(-0.5f) == -0.5f);
}

TEST_CASE("decode undoes encode", "[image][gamma]")
{
    for (const TransferCurve& curve : {TransferCurve::linear(), TransferCurve::srgb(), TransferCurve::power(2.2f),
                                       TransferCurve::power(1.8f), TransferCurve::bt709(), TransferCurve::bt2020()})
        for (int i = 0; i <= 1000; ++i) {
            const float x = static_cast<float>(i) / 800.0f;
            CHECK(curve.decode(curve.encode(x)) == Approx(x).margin(1e-6));
        }
}

TEST_CASE("the language version decides where a scene names no gamma", "[image][gamma]")
{
    const TransferCurve srgb = TransferCurve::srgb();
    const OutputCurves implied = output_curves({}, 370, srgb, srgb);
    CHECK(implied.working == TransferCurve::linear());
    CHECK(implied.file == srgb);
    const OutputCurves off = output_curves({}, 362, TransferCurve::linear(), TransferCurve::power(1.8f));
    CHECK(Transcoder(off.working, off.file).to_file(-0.3f) == -0.3f);
    CHECK(off.file == TransferCurve::power(1.8f));
    const OutputCurves given = output_curves(TransferCurve::power(2.2f), 350, srgb, srgb);
    CHECK(given.working == TransferCurve::power(2.2f));
    CHECK(given.file == srgb);
}
