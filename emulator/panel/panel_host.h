#pragma once

#include "display_content.h"
#include "virtual_sensor.h"

#include <memory>
#include <QByteArray>

namespace lds::emulator {

class PanelScreen;

/// What a screen may ask of the panel it is shown on.
class PanelHost {
public:
    virtual ~PanelHost() = default;

    virtual VirtualSensor& sensor() = 0;
    virtual EmulatorClock& clock() = 0;
    virtual PanelLanguage language() const = 0;
    virtual QByteArray macAddress() const = 0; ///< Six bytes.

    virtual void open(std::unique_ptr<PanelScreen> screen) = 0; ///< On top of the screen that asks.
    virtual void close() = 0;    ///< The one on top; the one below shows again.
    virtual void closeAll() = 0; ///< Back to the measurement display.
    virtual void lockKeys() = 0; ///< §4.12.1, and says so.
    virtual bool isOnTop(const PanelScreen* screen) const = 0;
    virtual void changed() = 0; ///< There is something else to be seen.

    /// The text in the sensor's language; `english` as the catalog or panel_text.h has it.
    QString text(const char* english) const;
};

} // namespace lds::emulator
