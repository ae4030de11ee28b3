#include "model_guess.h"

#include <QtTest>

using namespace lds::settings;
using namespace lds::catalog;

namespace {

constexpr ModelMask mask30 = maskOf(SensorModel::HlG203);
constexpr ModelMask mask250 = maskOf(SensorModel::HlG225);
constexpr ModelMask maskMiddle =
    maskOf(SensorModel::HlG205) | maskOf(SensorModel::HlG208) | maskOf(SensorModel::HlG212);

} // namespace

class ModelGuessTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingReadFitsEveryModel() { QCOMPARE(int(modelsThatFit({})), int(everyModel)); }
    void theDigitsTellTheThreeGroupsApart_data();
    void theDigitsTellTheThreeGroupsApart();
    void aLengthRulesOutTheSmallerTypes_data();
    void aLengthRulesOutTheSmallerTypes();
    void aHysteresisIsNeverNegative();
    void itemsThatDoNotTellAreIgnored();
    void valuesThatExcludeEachOtherFitNothing();
    void valuesFinerThanTheResolutionStillFit();
    void defaultsOfEveryModelFitIt();
};

void ModelGuessTest::theDigitsTellTheThreeGroupsApart_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("models");
    QTest::newRow("4 digits") << 0 << int(mask30);
    QTest::newRow("3 digits") << 1 << int(mask30 | maskMiddle);
    QTest::newRow("2 digits") << 2 << int(everyModel);
    QTest::newRow("1 digit") << 3 << int(everyModel);
    QTest::newRow("0 digits") << 4 << int(maskMiddle | mask250);
    QTest::newRow("no such code") << 5 << 0;
}

void ModelGuessTest::theDigitsTellTheThreeGroupsApart()
{
    QFETCH(int, code);
    QTEST(int(modelsThatFit({{ItemId::DisplayDigit, code}})), "models");
}

void ModelGuessTest::aLengthRulesOutTheSmallerTypes_data()
{
    QTest::addColumn<ItemId>("item");
    for (const ItemId item :
         {ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis, ItemId::Offset, ItemId::Tolerance})
        QTest::newRow(hlG2(item).key) << item;
}

void ModelGuessTest::aLengthRulesOutTheSmallerTypes()
{
    QFETCH(ItemId, item);
    QCOMPARE(int(modelsThatFit({{item, 95'000}})), int(everyModel));
    QCOMPARE(int(modelsThatFit({{item, 95'001}})), int(maskMiddle | mask250));
    QCOMPARE(int(modelsThatFit({{item, 950'001}})), int(mask250));
    QCOMPARE(int(modelsThatFit({{item, 9'500'001}})), 0);
}

void ModelGuessTest::aHysteresisIsNeverNegative()
{
    QCOMPARE(int(modelsThatFit({{ItemId::Hysteresis, -1}})), 0);
    QCOMPARE(int(modelsThatFit({{ItemId::LowSetValue, -1}})), int(everyModel));
}

void ModelGuessTest::itemsThatDoNotTellAreIgnored()
{
    QCOMPARE(int(modelsThatFit({{ItemId::MeasuredValue, 9'999'999}, {ItemId::Span, 5}})), int(everyModel));
}

void ModelGuessTest::valuesThatExcludeEachOtherFitNothing()
{
    QCOMPARE(int(modelsThatFit({{ItemId::DisplayDigit, 0}, {ItemId::HighSetValue, 950'000}})), 0);
}

/// Teaching may store what a person cannot set.
void ModelGuessTest::valuesFinerThanTheResolutionStillFit()
{
    QCOMPARE(int(modelsThatFit({{ItemId::HighSetValue, 12'345}})), int(everyModel));
}

void ModelGuessTest::defaultsOfEveryModelFitIt()
{
    for (const ModelDescription& model : Catalog::hlG2().models()) {
        Values defaults;
        for (const SettingItem& item : Catalog::hlG2().items())
            defaults[item.id] = item.limitsFor(model.model).defaultValue;
        QVERIFY2(modelsThatFit(defaults) & maskOf(model.model), model.typeName);
    }
}

QTEST_APPLESS_MAIN(ModelGuessTest)
#include "tst_model_guess.moc"
