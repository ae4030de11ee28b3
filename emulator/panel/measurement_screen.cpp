#include "measurement_screen.h"

#include "entry_digits.h"
#include "entry_screen.h"
#include "menu_screen.h"
#include "message_screen.h"
#include "panel_text.h"
#include "sensor_view.h"
#include "teaching_screen.h"

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

const char* displayName(ItemId item)
{
    const MenuEntry* entry = Catalog::hlG2().findMenu(hlG2(item).menu);
    return entry ? entry->name : hlG2(item).name;
}

void MeasurementScreen::gesture(Gesture gesture)
{
    switch (gesture) {
    case Gesture::Enter:
        host().open(std::make_unique<ReceivedLightScreen>(host()));
        break;
    case Gesture::Up:
        host().open(std::make_unique<WindowValueScreen>(host(), ItemId::HighSetValue));
        break;
    case Gesture::Down:
        host().open(std::make_unique<WindowValueScreen>(host(), ItemId::LowSetValue));
        break;
    case Gesture::HoldEnter:
        host().open(std::make_unique<MenuScreen>(host()));
        break;
    case Gesture::HoldUp:
        startTeaching();
        break;
    case Gesture::UpDown: // refused while unmeasurable: then nothing changes (§4.10)
        command(ItemId::ZeroSetting, 1);
        break;
    case Gesture::DownEnter:
        command(ItemId::ZeroSetting, 0);
        break;
    case Gesture::UpEnter:
        command(ItemId::MeasuredValueResetting, 0);
        break;
    case Gesture::HoldUpDown:
        host().lockKeys();
        break;
    case Gesture::HoldDown:
        break;
    }
}

void MeasurementScreen::startTeaching()
{
    if (const auto outcome = sensor().startTeaching(Operator::Keys); outcome.refusal)
        host().open(std::make_unique<MessageScreen>(host(), words::error)); // §4.9: with a hold mode
    else
        host().open(std::make_unique<TeachingScreen>(host()));
}

void MeasurementScreen::command(ItemId item, Value value) { sensor().writeByKeys({{item, value}}); }

void MeasurementScreen::draw(DisplayContent& content) const
{
    content.screen = ScreenKind::Measurement;
    content.icons = iconsOf(sensor());
    content.body = errorText(sensor());
    if (!content.body.isEmpty())
        return;
    content.body = measuredValueText(sensor(), displayDecimals(sensor()));
    content.unit = u"mm"_s;
}

void ReceivedLightScreen::gesture(Gesture gesture)
{
    if (gesture == Gesture::Enter || gesture == Gesture::HoldEnter)
        host().close();
}

void ReceivedLightScreen::draw(DisplayContent& content) const
{
    content.screen = ScreenKind::ReceivedLight;
    content.title = host().text(words::receivedLight);
    content.body = receivedLightText(sensor());
}

void WindowValueScreen::gesture(Gesture gesture)
{
    switch (gesture) {
    case Gesture::Enter: // what is stored then shows on the measurement display again
        host().open(std::make_unique<EntryScreen>(host(), ScreenTitle{0, 0, displayName(m_item)},
                                                  QList{m_item}, [panel = &host()] { panel->closeAll(); }));
        break;
    case Gesture::Up:
    case Gesture::Down:
    case Gesture::HoldEnter:
        host().close();
        break;
    default:
        break;
    }
}

void WindowValueScreen::draw(DisplayContent& content) const
{
    content.screen = ScreenKind::WindowValue;
    content.title = host().text(displayName(m_item));
    content.body = setValueText(m_item, sensor());
    content.unit = u"mm"_s;
}

} // namespace lds::emulator
