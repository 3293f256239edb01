#include "render/web/page.h"
#include "render/web/web.h"

#include <httplib.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <thread>

namespace web {
namespace {

constexpr int kPages = 8;        ///< that may be open at a time: each holds a thread
constexpr int kOthers = 8;       ///< threads for all else
constexpr int kReadSeconds = 2;  ///< a request that does not arrive in so long is dropped, and its thread is free again
constexpr std::size_t kMostBytes = 65536;  ///< of a request

/// So that the time it takes does not say how much of a guess is right.
bool same(const std::string& a, const std::string& b)
{
    unsigned differs = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) differs |= static_cast<unsigned>(a[i] ^ b[i]);
    return differs == 0;
}

class HttpServer final : public Server {
public:
    HttpServer(int port, const char* token, Host& host) : host_(host), base_(std::string("/") + token + "/")
    {
        http_.new_task_queue = [] { return new httplib::ThreadPool(kPages + kOthers); };
        http_.set_payload_max_length(kMostBytes);
        http_.set_read_timeout(kReadSeconds);
        http_.set_write_timeout(kReadSeconds);
        http_.set_keep_alive_timeout(kReadSeconds);
        http_.set_tcp_nodelay(true);
        // Nobody but a page of this address: a name that leads here from elsewhere is not ours.
        http_.set_pre_routing_handler(
            [this](const httplib::Request& request, httplib::Response& response) { return let_in(request, response); });
        http_.set_exception_handler(
            [](const httplib::Request&, httplib::Response& response, std::exception_ptr) { response.status = 500; });
        for (const char* path :
             {"set", "compare", "show", "write", "open"})  // requests with a body; all else is answered before routing
            http_.Post(base_ + path, [this](const httplib::Request& q, httplib::Response& r) { answer(true, q, r); });
        port_ = port == 0 ? http_.bind_to_any_port("127.0.0.1") : http_.bind_to_port("127.0.0.1", port) ? port : -1;
        if (port_ > 0) listening_ = std::thread([this] { http_.listen_after_bind(); });
    }
    ~HttpServer() override
    {
        ending_ = true;
        http_.stop();
        if (listening_.joinable()) listening_.join();
    }
    int port() const override { return port_; }

private:
    using Handled = httplib::Server::HandlerResponse;

    Handled let_in(const httplib::Request& request, httplib::Response& response)
    {
        const std::string host = request.get_header_value("Host"), number = std::to_string(port_);
        const bool ours = host == "127.0.0.1:" + number || host == "localhost:" + number;
        const bool below = same(request.path.substr(0, base_.size()), base_);
        if (ours && below && request.method == "POST") return Handled::Unhandled;
        if (ours && below && request.method == "GET") answer(false, request, response);
        else response.status = 404;
        return Handled::Handled;
    }

    void answer(bool posted, const httplib::Request& request, httplib::Response& response)
    {
        response.set_header("Cache-Control", "no-store");
        response.set_header("X-Content-Type-Options", "nosniff");
        response.set_header("Referrer-Policy", "no-referrer");
        const std::string path = request.path.substr(base_.size());
        if (!posted && path.empty()) {
            response.set_header("Content-Security-Policy",
                                "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                                "connect-src 'self'; img-src data:");
            return response.set_content(kPage, std::strlen(kPage), "text/html; charset=utf-8");
        }
        if (!posted && path == "events") return stream(response);
        std::string query;
        for (const auto& [name, value] : request.params) query += (query.empty() ? "" : "&") + name + "=" + value;
        const Reply reply = host_.answer(posted, path, posted ? request.body : query);
        response.status = reply.status;
        response.set_content(reply.body, reply.type.c_str());
    }

    void stream(httplib::Response& response)
    {
        if (++pages_ > kPages) {
            --pages_;
            response.status = 503;
            return;
        }
        const auto position = std::make_shared<std::uint64_t>(0);
        response.set_chunked_content_provider(
            "text/event-stream",
            [this, position](std::size_t, httplib::DataSink& sink) {
                std::string text;
                if (ending_ || !host_.events(*position, text)) return false;
                if (text.empty()) text = ":\n\n";  // whether somebody is still there
                return sink.write(text.data(), text.size());
            },
            [this](bool) { --pages_; });
    }

    Host& host_;
    const std::string base_;
    httplib::Server http_;
    std::thread listening_;
    std::atomic<int> pages_ = 0;
    std::atomic<bool> ending_ = false;
    int port_ = -1;
};

}  // namespace
}  // namespace web

extern "C" __attribute__((visibility("default"))) web::Server* whittle_web(int port, const char* token, web::Host& host,
                                                                           std::string& why)
{
    auto server = std::make_unique<web::HttpServer>(port, token, host);
    if (server->port() > 0) return server.release();
    why = port == 0 ? "no port is free" : "port " + std::to_string(port) + " is not free";
    return nullptr;
}
