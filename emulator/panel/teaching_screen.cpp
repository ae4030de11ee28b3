#include "teaching_screen.h"

#include "entry_digits.h"
#include "measurement_screen.h"
#include "panel_text.h"
#include "sensor_view.h"

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

TeachingScreen::TeachingScreen(PanelHost& host)
    : PanelScreen(host)
    , m_points(host.sensor().teaching().points())
{}

void TeachingScreen::gesture(Gesture gesture)
{
    if (m_step != Step::Prompt)
        return;
    if (gesture == Gesture::Enter) {
        takePoint();
    } else if (gesture == Gesture::HoldEnter) {
        sensor().interruptTeaching();
        host().close();
    }
}

void TeachingScreen::takePoint()
{
    if (sensor().takeTeachingPoint(m_point).refusal) {
        sensor().interruptTeaching();
        showFor(Step::Failed, [this] { host().close(); });
        return;
    }
    followSensor();
}

void TeachingScreen::refresh() { followSensor(); }

void TeachingScreen::followSensor()
{
    if (m_step != Step::Prompt)
        return;
    switch (sensor().teaching().state()) {
    case TeachingState::Success:
        showFor(Step::Success,
                [this] { showFor(Step::High, [this] { showFor(Step::Low, [this] { host().close(); }); }); });
        break;
    case TeachingState::Failed:
        showFor(Step::Failed, [this] { host().close(); });
        break;
    case TeachingState::NotExecuted: // taken away from outside
        host().close();
        break;
    case TeachingState::Executing:
        m_point = sensor().teaching().nextPoint();
        break;
    }
}

void TeachingScreen::showFor(Step step, std::function<void()> then)
{
    m_step = step;
    later(messageMs, std::move(then));
}

const char* TeachingScreen::prompt() const
{
    if (m_points == 1)
        return words::setTarget;
    return m_point == 1   ? words::setFirstTarget
           : m_point == 2 ? words::setSecondTarget
                          : words::setThirdTarget;
}

void TeachingScreen::draw(DisplayContent& content) const
{
    const auto setValue = [&](ItemId item) {
        content.screen = ScreenKind::WindowValue;
        content.title = host().text(displayName(item));
        content.body = setValueText(item, sensor());
        content.unit = u"mm"_s;
    };
    switch (m_step) {
    case Step::Prompt: // the display digit setting does not count here (§4.8.1)
        content.screen = ScreenKind::Prompt;
        content.title = host().text(prompt());
        content.body = measuredValueText(sensor(), fullDecimals(sensor()));
        content.unit = u"mm"_s;
        break;
    case Step::High:
        setValue(ItemId::HighSetValue);
        break;
    case Step::Low:
        setValue(ItemId::LowSetValue);
        break;
    case Step::Success:
    case Step::Failed:
        content.screen = ScreenKind::Message;
        content.body = host().text(m_step == Step::Success ? words::success : words::failed);
        break;
    }
}

} // namespace lds::emulator
