#include "reconnect_policy.h"

#include <algorithm>

namespace lds::sensor {

ReconnectPolicy::ReconnectPolicy(int firstMs, int longestMs)
    : m_firstMs(std::max(1, firstMs))
    , m_longestMs(std::max(m_firstMs, longestMs))
    , m_nextMs(m_firstMs)
{}

int ReconnectPolicy::nextDelayMs(ports::OpenFailure failure)
{
    switch (failure) {
    case ports::OpenFailure::HostNotFound:
    case ports::OpenFailure::NotASensor:
    case ports::OpenFailure::PortNotPermitted:
    case ports::OpenFailure::PortUnusable:
    case ports::OpenFailure::PortSettingsDiffer:
        return m_longestMs;
    case ports::OpenFailure::NotReady:
    case ports::OpenFailure::NoSuchPort:
    case ports::OpenFailure::PortGone:
        return m_firstMs;
    default:
        break;
    }
    const int delay = m_nextMs;
    m_nextMs = m_nextMs > m_longestMs / 2 ? m_longestMs : m_nextMs * 2;
    return delay;
}

void ReconnectPolicy::reset() { m_nextMs = m_firstMs; }

} // namespace lds::sensor
