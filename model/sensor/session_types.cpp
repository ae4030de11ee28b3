#include "session_types.h"

#include <utility>

namespace lds::sensor {

Lease::Lease(Lease&& other) noexcept
    : m_desk(std::exchange(other.m_desk, nullptr))
{}

Lease& Lease::operator=(Lease&& other) noexcept
{
    if (this != &other) {
        release();
        m_desk = std::exchange(other.m_desk, nullptr);
    }
    return *this;
}

Lease::~Lease() { release(); }

void Lease::release()
{
    const auto desk = std::exchange(m_desk, nullptr);
    if (!desk)
        return;
    desk->taken = false;
    if (desk->changed)
        desk->changed();
}

LeaseDesk::LeaseDesk(std::function<void()> changed)
    : m_state(std::make_shared<Lease::State>())
{
    m_state->changed = std::move(changed);
}

LeaseDesk::~LeaseDesk() { m_state->changed = nullptr; }

Lease LeaseDesk::acquire()
{
    if (m_state->taken)
        return {};
    m_state->taken = true;
    Lease lease(m_state);
    if (m_state->changed)
        m_state->changed();
    return lease;
}

} // namespace lds::sensor
