#include "verification/framework/source.h"

#include <catch2/catch.hpp>

namespace source_test {

using verification::items_of;
using Items = std::vector<std::string>;

TEST_CASE("items_of splits a place into the single equations, algorithms and sections") {
    CHECK(items_of("Eq. 13") == Items{"Eq. 13"});
    CHECK(items_of("Eqs. 9, 13") == Items{"Eq. 9", "Eq. 13"});
    CHECK(items_of("Eqs. 86-88, 92; Alg. 4") ==
          Items{"Eq. 86", "Eq. 87", "Eq. 88", "Eq. 92", "Alg. 4"});
    CHECK(items_of("Sec. 5.2; Table 1") == Items{"Sec. 5.2", "Table 1"});
    CHECK(items_of("Wendland 1995") == Items{"Wendland 1995"});
    CHECK(items_of("") == Items{});
}

}  // namespace source_test
