#include "item_screens.h"

#include "choice_screen.h"
#include "entry_screen.h"
#include "message_screen.h"
#include "panel_text.h"
#include "tuning_screen.h"

namespace lds::emulator {

using namespace catalog;

namespace {

ScreenTitle titleOf(const MenuEntry& entry) { return {entry.number, entry.level(), entry.name}; }

/// The address the sensor was built with: to be looked at only (§5.1.1).
class MacAddressScreen final : public PanelScreen {
public:
    MacAddressScreen(PanelHost& host, const ScreenTitle& title)
        : PanelScreen(host)
        , m_title(title)
    {}
    void gesture(Gesture gesture) override
    {
        if (gesture == Gesture::Enter || gesture == Gesture::HoldEnter)
            host().close();
    }
    void draw(DisplayContent& content) const override
    {
        content.screen = ScreenKind::Choice;
        drawTitle(content, m_title, host());
        content.body = QString::fromLatin1(host().macAddress().toHex(':')).toUpper();
    }

private:
    ScreenTitle m_title;
};

/// The choices this type of sensor has.
QList<ChoiceScreen::Option> optionsOf(const SettingItem& item, SensorModel model)
{
    QList<ChoiceScreen::Option> options;
    for (const Choice& choice : item.choices) {
        if (choice.models & maskOf(model))
            options.append({choice.name, choice.code});
    }
    return options;
}

/// Carries a choice out with a write, by its kind of item.
bool choose(PanelHost& host, ItemId item, Value value)
{
    if (item == ItemId::BrightnessTuning && value != 0) { // §4.3.3: ON starts the tuning
        if (host.sensor().startTuning(Operator::Keys).refusal)
            return false;
        host.close();
        host.open(std::make_unique<TuningScreen>(host));
        return true;
    }
    if (host.sensor().writeByKeys({{item, value}}).refusal)
        return false;
    host.close();
    if (item == ItemId::SettingsInitialization) // keys wait until it is done (§4.8.6)
        host.open(std::make_unique<MessageScreen>(host, words::initializing));
    return true;
}

std::unique_ptr<PanelScreen> initialPolarityScreen(PanelHost& host)
{
    constexpr auto npn = Value(InputPolarity::Npn);
    constexpr auto pnp = Value(InputPolarity::Pnp);
    auto screen = std::make_unique<ChoiceScreen>(
        host, ScreenTitle{0, 0, words::polarity}, QList<ChoiceScreen::Option>{{"NPN", npn}, {"PNP", pnp}},
        Value(host.sensor().memory().inputPolarity()), [panel = &host](Value polarity) {
            panel->sensor().setInputPolarity(InputPolarity(polarity));
            panel->close();
            return true;
        });
    screen->forbidSuspending();
    return screen;
}

} // namespace

std::unique_ptr<PanelScreen> itemScreen(const MenuEntry& entry, PanelHost& host)
{
    const SettingItem& item = hlG2(entry.items.front());
    const ScreenTitle title = titleOf(entry);
    if (item.kind == Kind::MacAddress)
        return std::make_unique<MacAddressScreen>(host, title);

    const auto chosen = [panel = &host, id = item.id](Value value) { return choose(*panel, id, value); };
    if (item.kind == Kind::Trigger) { // §4.8.5
        const QList<ChoiceScreen::Option> options{{words::cancel, {}}, {words::reset, 0}};
        return std::make_unique<ChoiceScreen>(host, title, options, std::nullopt, chosen);
    }
    if (item.role == Role::Command) { // §4.8.6
        QList<ChoiceScreen::Option> options{{words::cancel, {}}};
        options += optionsOf(item, host.sensor().model());
        return std::make_unique<ChoiceScreen>(host, title, options, std::nullopt, chosen);
    }
    if (item.kind == Kind::Choice) {
        return std::make_unique<ChoiceScreen>(host, title, optionsOf(item, host.sensor().model()),
                                              host.sensor().memory().value(item.id), chosen);
    }
    return std::make_unique<EntryScreen>(host, title, QList<ItemId>(entry.items.begin(), entry.items.end()));
}

std::unique_ptr<PanelScreen> initialLanguageScreen(PanelHost& host)
{
    const SettingItem& item = hlG2(ItemId::LanguageSetting);
    const MenuEntry* entry = Catalog::hlG2().findMenu(item.menu);
    auto screen = std::make_unique<ChoiceScreen>(
        host, ScreenTitle{0, 0, entry->name}, optionsOf(item, host.sensor().model()),
        host.sensor().memory().value(item.id), [panel = &host](Value language) {
            if (panel->sensor().writeByKeys({{ItemId::LanguageSetting, language}}).refusal)
                return false;
            panel->close();
            panel->open(initialPolarityScreen(*panel));
            return true;
        });
    screen->forbidSuspending();
    return screen;
}

} // namespace lds::emulator
