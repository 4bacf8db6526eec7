#include "solver/io/base64.h"

#include <catch2/catch.hpp>

namespace base64_test {

using namespace plumbline;

TEST_CASE("base64: the test vectors of RFC 4648, both ways", "[io]") {
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) {
        CHECK(encode_base64(bytes) == text);
        CHECK(decode_base64(text) == bytes);
    }
}

TEST_CASE("base64: all byte values, joined pieces, blanks", "[io]") {
    std::string all;
    for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
    CHECK(decode_base64(encode_base64(all)) == all);
    CHECK(decode_base64("Zg==Zm9v\n Zm8=") == "ffoofo");
}

TEST_CASE("base64: what is none is refused", "[io]") {
    for (const char* wrong : {"Z", "Zm9", "Zg=a", "Z===", "====", "Zm9v*", "Zm9vZ"})
        CHECK_FALSE(decode_base64(wrong));
}

}  // namespace base64_test
