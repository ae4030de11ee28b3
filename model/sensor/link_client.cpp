#include "link_client.h"

namespace lds::sensor {

LinkClient::LinkClient(ports::LinkPointer link, QObject* parent)
    : QObject(parent)
    , m_link(std::move(link))
{
    // Queued even when the link lives in this thread: no answer arrives inside the call that asked.
    const auto whileAlive = [this](auto signal) {
        return [this, signal](const auto&... arguments) {
            if (m_link)
                Q_EMIT(this->*signal)(arguments...);
        };
    };
    connect(m_link.get(), &ports::SensorLink::reported, this, whileAlive(&LinkClient::reported),
            Qt::QueuedConnection);
    connect(m_link.get(), &ports::SensorLink::measured, this, whileAlive(&LinkClient::measured),
            Qt::QueuedConnection);
    connect(m_link.get(), &ports::SensorLink::pollRefused, this, whileAlive(&LinkClient::pollRefused),
            Qt::QueuedConnection);
    connect(m_link.get(), &ports::SensorLink::finished, this, &LinkClient::finish, Qt::QueuedConnection);
}

LinkClient::~LinkClient() = default;

void LinkClient::open()
{
    if (m_link)
        m_link->open();
}

void LinkClient::poll(int intervalMs)
{
    if (m_link)
        m_link->poll(intervalMs);
}

void LinkClient::submit(ports::Request request, QObject* context, Handler handler)
{
    if (!m_link)
        return;
    request.id = m_nextId++;
    m_waiting.insert(request.id, {context, std::move(handler)});
    m_link->submit(request);
}

void LinkClient::shutDown()
{
    m_waiting.clear();
    if (m_link) {
        m_link->disconnect(this);
        m_link->close();
        m_link.reset();
    }
    deleteLater();
}

void LinkClient::finish(const ports::Outcome& outcome)
{
    const auto found = m_waiting.constFind(outcome.id);
    if (found == m_waiting.constEnd())
        return;
    const Waiting waiting = m_waiting.take(outcome.id);
    if (waiting.context)
        waiting.handler(outcome);
}

} // namespace lds::sensor
