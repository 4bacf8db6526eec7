// Every claim is a Catch2 test of its own name, and so a CTest test.
#define CATCH_CONFIG_RUNNER
#include "verification/framework/registry.h"

#include <catch2/catch.hpp>

namespace {
using namespace verification;

class ClaimTest : public Catch::ITestInvoker {
public:
    explicit ClaimTest(const Claim& claim) : claim_{&claim} {}
    void invoke() const override {
        const ClaimResult result = measure(*claim_);
        INFO(claim_->says << "\nmeasured " << result.measured << ", bound [" << claim_->bound.low
                          << ", " << claim_->bound.high << "] because " << claim_->bound.why << "\n"
                          << result.error);
        CHECK(name_of(result.verdict) == name_of(Verdict::verified));
    }

private:
    const Claim* claim_;
};
}  // namespace

int main(int argc, char** argv) {
    for (const Claim& claim : claims())
        Catch::AutoReg(new ClaimTest(claim), CATCH_INTERNAL_LINEINFO, "",
                       Catch::NameAndTags(claim.id, "[claim]"));
    return Catch::Session().run(argc, argv);
}
