#pragma once

#include "panel_screen.h"

namespace lds::emulator {

/// Teaching with 1, 2 or 3 targets by the keys (§4.9), already started at the sensor: "Set Target - Push
/// ENTER SW" for each, then "Success" and the new HIGH and LOW set values one after the other, or "Failed".
/// A long ENTER breaks it off.
class TeachingScreen final : public PanelScreen {
public:
    explicit TeachingScreen(PanelHost& host);

    void gesture(Gesture gesture) override;
    void refresh() override;
    void draw(DisplayContent& content) const override;

private:
    enum class Step { Prompt, Success, High, Low, Failed };
    void takePoint();
    void followSensor();
    void showFor(Step step, std::function<void()> then);
    const char* prompt() const;

    int m_points; ///< 1 … 3
    int m_point = 1;
    Step m_step = Step::Prompt;
};

} // namespace lds::emulator
