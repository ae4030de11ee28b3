#pragma once

#include "panel_screen.h"

namespace lds::emulator {

/// The measurement display (§2.2). From here the keys reach everything else (§4.1).
class MeasurementScreen final : public PanelScreen {
public:
    using PanelScreen::PanelScreen;

    bool keepsSensorReady() const override { return true; }
    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;

private:
    void startTeaching();
    void command(catalog::ItemId item, catalog::Value value);
};

/// The peak intensity of the received light, 0 … 1023 (§4.1). Entered and left with ENTER.
class ReceivedLightScreen final : public PanelScreen {
public:
    using PanelScreen::PanelScreen;

    bool keepsSensorReady() const override { return true; }
    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;
};

/// HIGH or LOW set value below its name, from the measurement display (§4.4.1, §4.4.2). ENTER changes it,
/// UP, DOWN or a long ENTER leave it.
class WindowValueScreen final : public PanelScreen {
public:
    WindowValueScreen(PanelHost& host, catalog::ItemId item)
        : PanelScreen(host)
        , m_item(item)
    {}

    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;

private:
    catalog::ItemId m_item;
};

/// The name of an item on the display, that is of its menu entry.
const char* displayName(catalog::ItemId item);

} // namespace lds::emulator
