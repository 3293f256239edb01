#pragma once

#include <cstdint>
#include <string>

/// The one interface to the module that holds cpp-httplib. It serves one page on 127.0.0.1, and what a host answers.
namespace web {

/// What a host has to say to a request.
struct Reply {
    int status = 200;
    std::string type = "application/json";
    std::string body;
};

/// Who knows what the page shows. Called from the server's threads, several at a time.
class Host {
public:
    virtual ~Host() = default;

    /// \param posted  whether it is a request that asks for a change of what is shown
    /// \param path  behind the token, without a slash in front
    /// \param body  JSON, or empty
    virtual Reply answer(bool posted, const std::string& path, const std::string& body) = 0;

    /// Waits up to a second for events behind `position`, moves it and appends them as they go over the wire; at most
    /// some hundred kilobytes a call. \return false: the host has ended
    virtual bool events(std::uint64_t& position, std::string& out) = 0;
};

class Server {
public:
    virtual ~Server() = default;  ///< ends all requests
    virtual int port() const = 0;
};

/// What the module's entry does.
/// \param port  0: any that is free
/// \param why  gets the reason where null is returned
using StartServer = Server* (*)(int port, const char* token, Host& host, std::string& why);

inline constexpr const char* kWebModuleName = "libwhittle_web.so";
inline constexpr const char* kWebModuleEntry = "whittle_web";

}  // namespace web
