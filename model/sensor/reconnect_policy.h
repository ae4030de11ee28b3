#pragma once

#include "sensor_link.h"

namespace lds::sensor {

/// How long to wait before the next try: doubling from the first to the longest delay. A host that does
/// not exist or is no sensor is asked at the slow pace at once: a person has to change something; so is a
/// serial port that cannot be used. A sensor in its menu is asked at the quick pace for as long as it takes:
/// somebody stands at its keys; and an adapter that is not plugged in is looked for at that pace.
class ReconnectPolicy {
public:
    ReconnectPolicy(int firstMs, int longestMs);

    int nextDelayMs(ports::OpenFailure failure);
    void reset(); ///< After a success.

private:
    int m_firstMs;
    int m_longestMs;
    int m_nextMs;
};

} // namespace lds::sensor
