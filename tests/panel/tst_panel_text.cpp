#include "catalog.h"
#include "panel_text.h"

#include <QRegularExpression>
#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::emulator;
using namespace Qt::StringLiterals;

/// The display's languages (§4.8.4).
class TestPanelText : public QObject {
    Q_OBJECT

private:
    /// "9600 bps", "NON + 2bit", "1 ms": the same in every language.
    static bool isFigures(const char* text)
    {
        static const QRegularExpression figures(u"^([0-9]+ (bps|ms|µs)|(NON|EVEN|ODD) \\+ [12]bit)$"_s);
        return figures.match(QString::fromUtf8(text)).hasMatch();
    }

private Q_SLOTS:
    void every_name_in_the_menu_and_every_choice_is_translated()
    {
        for (const MenuEntry& entry : Catalog::hlG2().menu()) {
            QVERIFY2(hasPanelText(entry.name), entry.name);
            for (const ItemId item : entry.items) {
                for (const Choice& choice : hlG2(item).choices)
                    QVERIFY2(hasPanelText(choice.name) || isFigures(choice.name), choice.name);
            }
        }
    }

    void every_text_of_the_display_itself_is_translated()
    {
        for (const char* text :
             {words::receivedLight, words::setTarget, words::setFirstTarget, words::setSecondTarget,
              words::setThirdTarget, words::adjusting, words::success, words::failed, words::error,
              words::keyLockOn, words::keyLockOff, words::cancel, words::reset, words::initializing}) {
            QVERIFY2(hasPanelText(text), text);
            const QString english = QString::fromUtf8(text);
            QCOMPARE(panelText(text, PanelLanguage::English), english);
            QVERIFY2(panelText(text, PanelLanguage::Japanese) != english, text);
            QVERIFY2(panelText(text, PanelLanguage::SimplifiedChinese) != english, text);
        }
    }

    /// §4.3.1: 'The displayed unit ... "us" stands for microseconds.'
    void microseconds_are_displayed_as_us()
    {
        for (const auto language :
             {PanelLanguage::English, PanelLanguage::Japanese, PanelLanguage::SimplifiedChinese})
            QCOMPARE(panelText("100 µs", language), u"100 us"_s);
    }
};

QTEST_GUILESS_MAIN(TestPanelText)
#include "tst_panel_text.moc"
