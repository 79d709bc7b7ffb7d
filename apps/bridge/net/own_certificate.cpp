#include "bridge/net/own_certificate.h"

#include "common/process/private_files.h"

#include "rtcore/platform/error.h"

#include <boost/asio/ip/address.hpp>
#include <fmt/format.h>

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <memory>

namespace bridge {

namespace {

using rtcore::FailureKind;
using rtcore::FileError;

template <auto Free>
struct Freed {
    template <typename T>
    void operator()(T* object) const {
        Free(object);
    }
};
using Certificate = std::unique_ptr<X509, Freed<X509_free>>;
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using Text = std::unique_ptr<BIO, Freed<BIO_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION_free>>;

constexpr int kDay = 24 * 60 * 60, kDaysGood = 365, kDaysLeft = 30;

bool isAddress(const std::string& name) {
    boost::system::error_code error;
    boost::asio::ip::make_address(name, error);
    return !error;
}

/// An address, or a name of no other letters than those of host names: others would be read as OpenSSL's
/// own words.
bool canBeNamed(const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
               c == '-';
    };
    return isAddress(name) || (!name.empty() && std::all_of(name.begin(), name.end(), plain));
}

/// As OpenSSL takes it.
std::string listOf(const std::vector<std::string>& names) {
    std::string list = "DNS:localhost,IP:127.0.0.1,IP:::1";
    for (const std::string& name : names) {
        if (canBeNamed(name)) list += (isAddress(name) ? ",IP:" : ",DNS:") + name;
    }
    return list;
}

bool isGoodFor(X509& certificate, const std::string& name) {
    const int found = isAddress(name) ? X509_check_ip_asc(&certificate, name.c_str(), 0)
                                      : X509_check_host(&certificate, name.data(), name.size(), 0, nullptr);
    return found == 1;
}

bool isGoodStill(X509& certificate) {
    std::time_t later = std::time(nullptr) + std::time_t{kDaysLeft} * kDay;
    return X509_cmp_time(X509_get0_notAfter(&certificate), &later) > 0;
}

void extend(X509& certificate, int what, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx_nodb(&context);
    X509V3_set_ctx(&context, &certificate, &certificate, nullptr, nullptr, 0);
    const Extension extension(X509V3_EXT_conf_nid(nullptr, &context, what, value.c_str()));
    if (extension) X509_add_ext(&certificate, extension.get(), -1);
}

/// Certificate and key, in PEM.
std::string newPem(const std::vector<std::string>& names) {
    const Key key(EVP_EC_gen("P-256"));
    const Certificate certificate(X509_new());
    std::uint64_t number = 0;
    RAND_bytes(reinterpret_cast<unsigned char*>(&number), sizeof number);
    X509_set_version(certificate.get(), X509_VERSION_3);
    ASN1_INTEGER_set_uint64(X509_get_serialNumber(certificate.get()), number >> 1U);
    X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -kDay);
    X509_gmtime_adj(X509_getm_notAfter(certificate.get()), long{kDaysGood} * kDay);
    X509_set_pubkey(certificate.get(), key.get());
    X509_NAME* const subject = X509_get_subject_name(certificate.get());
    constexpr const char* kSubject = "RTBridge";
    X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC, reinterpret_cast<const unsigned char*>(kSubject),
                               -1, -1, 0);
    X509_set_issuer_name(certificate.get(), subject);
    extend(*certificate, NID_basic_constraints, "critical,CA:FALSE");
    extend(*certificate, NID_ext_key_usage, "serverAuth");
    extend(*certificate, NID_subject_alt_name, listOf(names));
    if (!key || X509_sign(certificate.get(), key.get(), EVP_sha256()) == 0) return {};
    const Text text(BIO_new(BIO_s_mem()));
    PEM_write_bio_X509(text.get(), certificate.get());
    PEM_write_bio_PrivateKey(text.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
    char* bytes = nullptr;
    const long count = BIO_get_mem_data(text.get(), &bytes);
    return {bytes, static_cast<std::size_t>(count)};
}

Certificate readPem(const std::string& pem) {
    const Text text(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
    return Certificate(PEM_read_bio_X509(text.get(), nullptr, nullptr, nullptr));
}

std::string fingerprintOf(X509& certificate) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int count = 0;
    X509_digest(&certificate, EVP_sha256(), digest.data(), &count);
    return fmt::format("{:02X}", fmt::join(digest.data(), digest.data() + count, ":"));
}

} // namespace

OwnCertificate ownCertificate(const std::string& folder, const std::vector<std::string>& names) {
    if (!app::makePrivateFolder(folder))
        throw FileError(FailureKind::CannotWrite, folder, "this is no folder that only its owner can open");
    const std::string file = folder + "/certificate.pem";
    const auto kept = app::readPrivateFile(file);
    if (const Certificate old = readPem(kept.value_or(""))) {
        const auto good = [&](const std::string& name) { return !canBeNamed(name) || isGoodFor(*old, name); };
        if (isGoodStill(*old) && std::all_of(names.begin(), names.end(), good))
            return {file, fingerprintOf(*old)};
    }
    const std::string pem = newPem(names);
    const Certificate made = readPem(pem);
    if (!made) throw FileError(FailureKind::CannotWrite, file, "OpenSSL makes no certificate");
    std::error_code unknown;
    std::filesystem::remove(file, unknown);
    if (!app::writePrivateFile(file, pem))
        throw FileError(FailureKind::CannotWrite, file,
                        "another program writes it at this moment; try again");
    return {file, fingerprintOf(*made)};
}

} // namespace bridge
